package nephele.engine.cloud.field;

import java.util.Arrays;
import java.util.List;
import nephele.engine.math.Aabb;

/** Cells over the bounds of puffs: which puffs reach a cell, and the greatest density that they can have in it. */
final class PuffCells implements CellWalk.Bound {
    /** Cells along the longest edge of the bounds. */
    private static final int FINEST = 32;

    /** Entries of all cells' lists from which on cells are made coarser. */
    private static final int MOST_ENTRIES = 1 << 22;

    private final Aabb bounds;
    private final CellLattice lattice;
    private final int columns;
    private final int layers;
    private final int rows;
    private final int[][] reaching;
    private final int[] counts;
    private final double[] maxima;
    private int entries;

    private PuffCells(Aabb bounds, int along) {
        this.bounds = bounds;
        double x = bounds.maxX() - bounds.minX();
        double y = bounds.maxY() - bounds.minY();
        double z = bounds.maxZ() - bounds.minZ();
        double cell = Math.max(x, Math.max(y, z)) / along;
        columns = Math.max(1, (int) Math.ceil(x / cell));
        layers = Math.max(1, (int) Math.ceil(y / cell));
        rows = Math.max(1, (int) Math.ceil(z / cell));
        lattice = CellLattice.dividing(bounds, columns, layers, rows);
        reaching = new int[columns * layers * rows][0];
        counts = new int[reaching.length];
        maxima = new double[reaching.length];
    }

    /** Returns cells as fine as the puffs' overlaps allow; there must be at least one puff. */
    static PuffCells of(Aabb bounds, List<GaussianPuff> puffs) {
        for (int along = FINEST; ; along /= 2) {
            var cells = new PuffCells(bounds, along);
            for (int puff = 0; puff < puffs.size() && cells.isSparse(along); puff++) {
                cells.add(puff, puffs.get(puff));
            }
            if (cells.isSparse(along)) {
                return cells;
            }
        }
    }

    private boolean isSparse(int along) {
        return along == 1 || entries <= MOST_ENTRIES;
    }

    private void add(int number, GaussianPuff puff) {
        Aabb ball = puff.bounds();
        int lastI = column(ball.maxX());
        int lastJ = layer(ball.maxY());
        int lastK = row(ball.maxZ());
        for (int k = row(ball.minZ()); k <= lastK; k++) {
            for (int j = layer(ball.minY()); j <= lastJ; j++) {
                for (int i = column(ball.minX()); i <= lastI; i++) {
                    add(number, puff, i, j, k);
                }
            }
        }
    }

    private void add(int number, GaussianPuff puff, int i, int j, int k) {
        double x = lattice.originX() + i * lattice.sizeX();
        double y = lattice.originY() + j * lattice.sizeY();
        double z = lattice.originZ() + k * lattice.sizeZ();
        double most = puff.greatestIn(x, y, z, x + lattice.sizeX(), y + lattice.sizeY(), z + lattice.sizeZ());
        if (most > 0) {
            int cell = index(i, j, k);
            if (counts[cell] == reaching[cell].length) {
                reaching[cell] = Arrays.copyOf(reaching[cell], 2 * counts[cell] + 2);
            }
            reaching[cell][counts[cell]++] = number;
            maxima[cell] += most;
            entries++;
        }
    }

    CellLattice lattice() {
        return lattice;
    }

    /** Returns the cell of a point inside the bounds. */
    int cell(double x, double y, double z) {
        return index(column(x), layer(y), row(z));
    }

    /** Returns the number of puffs that reach a cell. */
    int reaching(int cell) {
        return counts[cell];
    }

    /** Returns the index of one of the puffs that reach a cell. */
    int puff(int cell, int number) {
        return reaching[cell][number];
    }

    private int column(double x) {
        return clamped((long) Math.floor((x - bounds.minX()) / lattice.sizeX()), columns);
    }

    private int layer(double y) {
        return clamped((long) Math.floor((y - bounds.minY()) / lattice.sizeY()), layers);
    }

    private int row(double z) {
        return clamped((long) Math.floor((z - bounds.minZ()) / lattice.sizeZ()), rows);
    }

    private static int clamped(long cell, int cells) {
        return (int) Math.max(0, Math.min(cell, cells - 1));
    }

    private int index(int i, int j, int k) {
        return (k * layers + j) * columns + i;
    }

    /** Returns the sum of the puffs' greatest densities in the cell. */
    @Override
    public double perMetre(long i, long j, long k) {
        return maxima[index(clamped(i, columns), clamped(j, layers), clamped(k, rows))];
    }
}
