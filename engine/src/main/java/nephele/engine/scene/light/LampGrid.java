package nephele.engine.scene.light;

import java.util.Arrays;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * Which lamps can reach which cell of a regular grid over the level, so that a pixel asks few of a thousand lamps. Lists
 * are complete: where many lamps have a long range the cells grow, no lamp is left out. Places beyond the grid belong
 * to its outermost cells.
 *
 * @param firstOfCell start of each cell's list in {@code lamps}, and one entry more; x varies fastest
 * @param lamps indices into the list of lamps, ascending within a cell
 */
public record LampGrid(Vec3 min, Vec3 cellMetres, int columns, int floors, int rows, int[] firstOfCell, int[] lamps) {
    private static final int MAX_CELLS = 1 << 13;
    private static final int MAX_ENTRIES = 1 << 17;
    private static final double FINEST_CELL_METRES = 1;

    /** Float coordinates in the shader may fall into the neighbouring cell. */
    private static final double OVERLAP = 1e-3;

    public static LampGrid of(List<Lamp> lamps, Aabb bounds) {
        Aabb box = bounds.isEmpty() ? new Aabb(0, 0, 0, 1, 1, 1) : bounds;
        double side = FINEST_CELL_METRES;
        while (cells(box.maxX() - box.minX(), side)
                        * cells(box.maxY() - box.minY(), side)
                        * cells(box.maxZ() - box.minZ(), side)
                > MAX_CELLS) {
            side *= 1.25;
        }
        while (true) {
            LampGrid grid = tryAt(lamps, box, side);
            if (grid.lamps.length <= MAX_ENTRIES || grid.firstOfCell.length == 2) {
                return grid;
            }
            side *= 2;
        }
    }

    private static double cells(double extent, double side) {
        return Math.max(1, Math.ceil(extent / side));
    }

    private static LampGrid tryAt(List<Lamp> lamps, Aabb box, double side) {
        int nx = (int) cells(box.maxX() - box.minX(), side);
        int ny = (int) cells(box.maxY() - box.minY(), side);
        int nz = (int) cells(box.maxZ() - box.minZ(), side);
        Vec3 min = new Vec3(box.minX(), box.minY(), box.minZ());
        Vec3 cell = new Vec3(
                cellSide(box.maxX() - box.minX(), nx),
                cellSide(box.maxY() - box.minY(), ny),
                cellSide(box.maxZ() - box.minZ(), nz));
        LampGrid empty = new LampGrid(min, cell, nx, ny, nz, new int[nx * ny * nz + 1], new int[0]);
        return empty.filled(lamps);
    }

    private static double cellSide(double extent, int cells) {
        return Math.max(extent, 1e-3) / cells;
    }

    private LampGrid filled(List<Lamp> all) {
        int[] first = new int[columns * floors * rows + 1];
        int[] entries = new int[64];
        int count = 0;
        for (int cell = 0; cell < first.length - 1; cell++) {
            first[cell] = count;
            Aabb box = reachOf(cell);
            for (int lamp = 0; lamp < all.size() && count <= MAX_ENTRIES; lamp++) {
                if (LampReach.touches(all.get(lamp), box)) {
                    entries = count == entries.length ? Arrays.copyOf(entries, 2 * count) : entries;
                    entries[count++] = lamp;
                }
            }
        }
        first[first.length - 1] = count;
        return new LampGrid(min, cellMetres, columns, floors, rows, first, Arrays.copyOf(entries, count));
    }

    /** The cell's box, a little grown; unbounded on the grid's outside. */
    private Aabb reachOf(int cell) {
        int x = cell % columns;
        int y = cell / columns % floors;
        int z = cell / columns / floors;
        return new Aabb(
                low(min.x(), cellMetres.x(), x),
                low(min.y(), cellMetres.y(), y),
                low(min.z(), cellMetres.z(), z),
                high(min.x(), cellMetres.x(), x, columns),
                high(min.y(), cellMetres.y(), y, floors),
                high(min.z(), cellMetres.z(), z, rows));
    }

    private static double low(double min, double side, int index) {
        return index == 0 ? -1e12 : min + (index - OVERLAP) * side;
    }

    private static double high(double min, double side, int index, int count) {
        return index == count - 1 ? 1e12 : min + (index + 1 + OVERLAP) * side;
    }

    /** As the shader finds it; for every point in space. */
    public int cellAt(Vec3 p) {
        int x = index((p.x() - min.x()) / cellMetres.x(), columns);
        int y = index((p.y() - min.y()) / cellMetres.y(), floors);
        int z = index((p.z() - min.z()) / cellMetres.z(), rows);
        return x + columns * (y + floors * z);
    }

    private static int index(double cell, int count) {
        return (int) Math.min(Math.max(cell, 0), count - 1);
    }
}
