package nephele.engine.level.billboard;

import java.util.Arrays;
import java.util.List;

/**
 * The points of an endless grid whose cells hold at most one: their diagonal is the least distance. A table with open
 * addressing, because an area may have many more cells than points.
 */
final class DiscCells {
    private static final int NONE = -1;
    /** Cells to either side in which a point can be too near. */
    private static final int REACH = 2;

    private final double spacing;
    private final double cell;
    private final int mask;
    private final long[] keys;
    private final int[] points;

    DiscCells(double spacing, int most) {
        this.spacing = spacing;
        cell = spacing / StrictMath.sqrt(2);
        int size = Integer.highestOneBit(Math.max(8, most)) * 4;
        mask = size - 1;
        keys = new long[size];
        points = new int[size];
        Arrays.fill(points, NONE);
    }

    private int column(double metres) {
        return (int) Math.floor(metres / cell);
    }

    /** Returns the slot of a cell: the one that holds it, or a free one. */
    private int slot(int x, int z) {
        long key = (long) x << 32 | z & 0xffffffffL;
        long mixed = key * 0x9E3779B97F4A7C15L;
        int slot = (int) (mixed >>> 32) & mask;
        while (points[slot] != NONE && keys[slot] != key) {
            slot = slot + 1 & mask;
        }
        keys[slot] = key;
        return slot;
    }

    void put(int point, double x, double z) {
        points[slot(column(x), column(z))] = point;
    }

    /** Returns true if no point is nearer than the spacing. */
    boolean isFree(List<double[]> all, double x, double z) {
        int column = column(x);
        int row = column(z);
        for (int i = column - REACH; i <= column + REACH; i++) {
            for (int j = row - REACH; j <= row + REACH; j++) {
                int point = points[slot(i, j)];
                if (point != NONE) {
                    double dx = all.get(point)[0] - x;
                    double dz = all.get(point)[1] - z;
                    if (dx * dx + dz * dz < spacing * spacing) {
                        return false;
                    }
                }
            }
        }
        return true;
    }
}
