package nephele.engine.scene.light;

import java.util.Arrays;
import java.util.List;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * Lists the punctual lights that can light the faces in each cell of a regular grid over the level, so that a pixel
 * evaluates few of a thousand lights. Lists are complete: if many lights have a long range the cells grow, and only
 * lights behind the face or hidden from the whole cell are omitted. Points outside the grid belong to its outermost
 * cells.
 *
 * @param min the grid's corner, world metres
 * @param cellMetres sides of a cell
 * @param firstOfList start of each list in {@code lights}, and one entry more; {@value #FACINGS} lists per cell, cells
 *     with x varying fastest
 * @param lights indices into the list of lights, ascending within a list
 */
public record LightGrid(Vec3 min, Vec3 cellMetres, int columns, int floors, int rows, int[] firstOfList, int[] lights) {
    /** One list for faces towards each of +x −x +y −y +z −z, and one for all others. */
    public static final int FACINGS = 7;

    private static final int MAX_CELLS = 1 << 13;
    private static final int MAX_ENTRIES = 1 << 17;

    /**
     * The greatest number of pairs of a light and a cell: each pair takes at least four entries, so more cannot fit.
     */
    static final int MOST_LIT = MAX_ENTRIES / 4;

    private static final double FINEST_CELL_METRES = 1;

    /** In cell sides: float coordinates in the shader may fall into the neighbouring cell. */
    private static final double OVERLAP_CELLS = 1e-3;

    /** Returns the side of the smallest cells that are allowed for the level's size, metres. */
    static double finestMetres(Aabb bounds) {
        double side = FINEST_CELL_METRES;
        while (cells(bounds.maxX() - bounds.minX(), side)
                        * cells(bounds.maxY() - bounds.minY(), side)
                        * cells(bounds.maxZ() - bounds.minZ(), side)
                > MAX_CELLS) {
            side *= 1.25;
        }
        return side;
    }

    private static double cells(double extent, double side) {
        return Math.max(1, Math.ceil(extent / side));
    }

    /** Returns a grid with empty lists. */
    static LightGrid over(Aabb box, double side) {
        int nx = (int) cells(box.maxX() - box.minX(), side);
        int ny = (int) cells(box.maxY() - box.minY(), side);
        int nz = (int) cells(box.maxZ() - box.minZ(), side);
        Vec3 min = new Vec3(box.minX(), box.minY(), box.minZ());
        Vec3 cell = new Vec3(
                cellSide(box.maxX() - box.minX(), nx),
                cellSide(box.maxY() - box.minY(), ny),
                cellSide(box.maxZ() - box.minZ(), nz));
        return new LightGrid(min, cell, nx, ny, nz, new int[FACINGS * nx * ny * nz + 1], new int[0]);
    }

    boolean hasSameCells(LightGrid other) {
        return min.equals(other.min)
                && cellMetres.equals(other.cellMetres)
                && columns == other.columns
                && floors == other.floors
                && rows == other.rows;
    }

    int cells() {
        return columns * floors * rows;
    }

    Aabb bounds() {
        return new Aabb(
                min.x(),
                min.y(),
                min.z(),
                min.x() + columns * cellMetres.x(),
                min.y() + floors * cellMetres.y(),
                min.z() + rows * cellMetres.z());
    }

    private static double cellSide(double extent, int cells) {
        return Math.max(extent, 1e-3) / cells;
    }

    /**
     * Returns the same cells with their lists.
     *
     * @return {@code null} if the lists are too long and the cells can be larger
     */
    LightGrid listing(List<PunctualLight> all, LightGridCells lit) {
        int most = cells() == 1 ? Integer.MAX_VALUE : MAX_ENTRIES;
        int[] first = new int[firstOfList.length];
        int[] entries = new int[64];
        int[] near = new int[all.size()];
        int count = 0;
        for (int cell = 0; cell < cells(); cell++) {
            int nearCount = near(cell, lit, near);
            Aabb box = nearCount == 0 ? Aabb.EMPTY : reachOf(cell);
            for (int facing = 0; facing < FACINGS; facing++) {
                first[FACINGS * cell + facing] = count;
                entries = count + nearCount > entries.length ? Arrays.copyOf(entries, 2 * count + nearCount) : entries;
                for (int i = 0; i < nearCount; i++) {
                    if (isBefore(facing, box, all.get(near[i]).position())) {
                        entries[count++] = near[i];
                    }
                }
            }
            if (count > most) {
                return null;
            }
        }
        first[first.length - 1] = count;
        return new LightGrid(min, cellMetres, columns, floors, rows, first, Arrays.copyOf(entries, count));
    }

    private static int near(int cell, LightGridCells lit, int[] near) {
        int count = 0;
        for (int light = 0; light < near.length; light++) {
            if (lit.mayLight(light, cell)) {
                near[count++] = light;
            }
        }
        return count;
    }

    /** Returns true if a light can be in front of a face in the box with the given facing. */
    private static boolean isBefore(int facing, Aabb box, Vec3 light) {
        return switch (facing) {
            case 0 -> light.x() > box.minX();
            case 1 -> light.x() < box.maxX();
            case 2 -> light.y() > box.minY();
            case 3 -> light.y() < box.maxY();
            case 4 -> light.z() > box.minZ();
            case 5 -> light.z() < box.maxZ();
            default -> true;
        };
    }

    /** Returns the index of a face's list in its cell, as the shader computes it. */
    public static int facingOf(Vec3 normal) {
        double limit = 0.9999;
        double[] n = {normal.x(), normal.y(), normal.z()};
        for (int axis = 0; axis < 3; axis++) {
            if (Math.abs(n[axis]) > limit) {
                return 2 * axis + (n[axis] < 0 ? 1 : 0);
            }
        }
        return FACINGS - 1;
    }

    Aabb boxOf(int cell) {
        int x = cell % columns;
        int y = cell / columns % floors;
        int z = cell / columns / floors;
        Vec3 c = cellMetres;
        return new Aabb(
                        min.x() + x * c.x(),
                        min.y() + y * c.y(),
                        min.z() + z * c.z(),
                        min.x() + (x + 1) * c.x(),
                        min.y() + (y + 1) * c.y(),
                        min.z() + (z + 1) * c.z())
                .grown(OVERLAP_CELLS * Math.max(c.x(), Math.max(c.y(), c.z())));
    }

    /** Returns the cell's box, slightly grown; unbounded on the grid's outside. */
    Aabb reachOf(int cell) {
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
        return index == 0 ? -1e12 : min + (index - OVERLAP_CELLS) * side;
    }

    private static double high(double min, double side, int index, int count) {
        return index == count - 1 ? 1e12 : min + (index + 1 + OVERLAP_CELLS) * side;
    }

    /** Returns the cell of any point in space, as the shader computes it. */
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
