package nephele.engine.sim.reach;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * Cubes of a box of the world. Each has the greatest height that an eye has had the energy to rise to when it was there,
 * and the means by which it came there first.
 */
final class ReachGrid {
    private static final double FINEST_METRES = 0.5;
    private static final int MOST_CELLS = 120_000;

    private final Aabb box;
    private final double cellMetres;
    private final int[] size = new int[3];
    private final float[] headMetres;
    private final byte[] means;
    /** The cells that wait to be visited, each once at a time, in a ring. */
    private final int[] ring;

    private final boolean[] isWaiting;
    private int first;
    private int waiting;

    ReachGrid(Aabb domain) {
        box = domain;
        double x = domain.maxX() - domain.minX();
        double y = domain.maxY() - domain.minY();
        double z = domain.maxZ() - domain.minZ();
        double cell = FINEST_METRES;
        while (Math.ceil(x / cell) * Math.ceil(y / cell) * Math.ceil(z / cell) > MOST_CELLS) {
            cell *= 1.1;
        }
        cellMetres = cell;
        size[0] = Math.max(1, (int) Math.ceil(x / cell));
        size[1] = Math.max(1, (int) Math.ceil(y / cell));
        size[2] = Math.max(1, (int) Math.ceil(z / cell));
        headMetres = new float[size[0] * size[1] * size[2]];
        means = new byte[headMetres.length];
        ring = new int[headMetres.length];
        isWaiting = new boolean[headMetres.length];
        Arrays.fill(headMetres, Float.NEGATIVE_INFINITY);
    }

    double cellMetres() {
        return cellMetres;
    }

    int cells() {
        return headMetres.length;
    }

    /** Returns the cell that contains a point; −1 outside. */
    int cell(Vec3 at) {
        int x = (int) Math.floor((at.x() - box.minX()) / cellMetres);
        int y = (int) Math.floor((at.y() - box.minY()) / cellMetres);
        int z = (int) Math.floor((at.z() - box.minZ()) / cellMetres);
        boolean isInside = x >= 0 && x < size[0] && y >= 0 && y < size[1] && z >= 0 && z < size[2];
        return isInside ? x + size[0] * (y + size[1] * z) : -1;
    }

    Vec3 centre(int cell) {
        return new Vec3(
                box.minX() + (cell % size[0] + 0.5) * cellMetres,
                box.minY() + (cell / size[0] % size[1] + 0.5) * cellMetres,
                box.minZ() + (cell / size[0] / size[1] + 0.5) * cellMetres);
    }

    /**
     * Returns the neighbour of a cell.
     *
     * @param side 0 to 5: towards lesser and greater x, y, z
     * @return −1 for none
     */
    int neighbour(int cell, int side) {
        int axis = side / 2;
        int stride = axis == 0 ? 1 : axis == 1 ? size[0] : size[0] * size[1];
        int at = cell / stride % size[axis];
        if (side % 2 == 0) {
            return at == 0 ? -1 : cell - stride;
        }
        return at == size[axis] - 1 ? -1 : cell + stride;
    }

    boolean isReached(int cell) {
        return headMetres[cell] != Float.NEGATIVE_INFINITY;
    }

    double head(int cell) {
        return headMetres[cell];
    }

    /** Raises the head of a cell; the first one decides its means. */
    void reach(int cell, double head, EyeReach.Means by) {
        if (!isReached(cell)) {
            means[cell] = (byte) by.ordinal();
        }
        headMetres[cell] = (float) head;
    }

    /** Returns true if the cell is at a side or at the bottom of the box. */
    boolean isAtEdge(int cell) {
        return neighbour(cell, 0) < 0
                || neighbour(cell, 1) < 0
                || neighbour(cell, 2) < 0
                || neighbour(cell, 4) < 0
                || neighbour(cell, 5) < 0;
    }

    EyeReach.Means means(int cell) {
        return EyeReach.Means.values()[means[cell]];
    }

    /** Returns boxes that hold the reached cells: runs along x of the same means, those of neighbouring z joined. */
    List<EyeReach.Part> parts() {
        List<EyeReach.Part> parts = new ArrayList<>();
        for (int y = 0; y < size[1]; y++) {
            List<EyeReach.Part> open = new ArrayList<>();
            for (int z = 0; z < size[2]; z++) {
                List<EyeReach.Part> joined = new ArrayList<>();
                for (EyeReach.Part run : runs(y, z)) {
                    joined.add(joined(run, open));
                }
                parts.addAll(open);
                open = joined;
            }
            parts.addAll(open);
        }
        return parts;
    }

    /** Returns a run together with the one before it in z, if that has the same ends; takes it from the list then. */
    private static EyeReach.Part joined(EyeReach.Part run, List<EyeReach.Part> before) {
        for (int i = 0; i < before.size(); i++) {
            EyeReach.Part other = before.get(i);
            boolean isSame = other.means() == run.means()
                    && other.box().minX() == run.box().minX()
                    && other.box().maxX() == run.box().maxX();
            if (isSame) {
                before.remove(i);
                return new EyeReach.Part(other.box().union(run.box()), run.means());
            }
        }
        return run;
    }

    private List<EyeReach.Part> runs(int y, int z) {
        List<EyeReach.Part> runs = new ArrayList<>();
        int row = size[0] * (y + size[1] * z);
        int x = 0;
        while (x < size[0]) {
            int from = x;
            while (x < size[0] && isReached(row + x) && means[row + x] == means[row + from]) {
                x++;
            }
            if (x > from) {
                runs.add(new EyeReach.Part(span(from, x, y, z), means(row + from)));
            } else {
                x++;
            }
        }
        return runs;
    }

    private Aabb span(int fromX, int toX, int y, int z) {
        return new Aabb(
                box.minX() + fromX * cellMetres,
                box.minY() + y * cellMetres,
                box.minZ() + z * cellMetres,
                box.minX() + toX * cellMetres,
                box.minY() + (y + 1) * cellMetres,
                box.minZ() + (z + 1) * cellMetres);
    }

    /** Lets a cell wait to be visited, in the order in which they came; one that already waits keeps its turn. */
    void enqueue(int cell) {
        if (!isWaiting[cell]) {
            isWaiting[cell] = true;
            ring[(first + waiting) % ring.length] = cell;
            waiting++;
        }
    }

    /** Takes the next cell; −1 if none waits. */
    int next() {
        if (waiting == 0) {
            return -1;
        }
        int cell = ring[first];
        first = (first + 1) % ring.length;
        waiting--;
        isWaiting[cell] = false;
        return cell;
    }
}
