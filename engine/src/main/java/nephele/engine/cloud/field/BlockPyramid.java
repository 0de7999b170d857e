package nephele.engine.cloud.field;

import java.util.ArrayList;
import java.util.List;

/**
 * Greatest values in the blocks of a map, in squares of 2 × 2 of them, and so on to one value for all, so that a bound in
 * a rectangle costs the same whatever its size.
 */
final class BlockPyramid {
    /** Blocks along a side of a rectangle up to which its bound is exact. */
    private static final int EXACT = 4;

    private final List<Level> levels = new ArrayList<>();

    private record Level(double[] greatest, int columns, int rows) {
        double at(int i, int k) {
            return greatest[Math.min(k, rows - 1) * columns + Math.min(i, columns - 1)];
        }

        Level coarser() {
            var coarser =
                    new Level(new double[((columns + 1) / 2) * ((rows + 1) / 2)], (columns + 1) / 2, (rows + 1) / 2);
            for (int k = 0; k < coarser.rows; k++) {
                for (int i = 0; i < coarser.columns; i++) {
                    coarser.greatest[k * coarser.columns + i] = Math.max(
                            Math.max(at(2 * i, 2 * k), at(2 * i + 1, 2 * k)),
                            Math.max(at(2 * i, 2 * k + 1), at(2 * i + 1, 2 * k + 1)));
                }
            }
            return coarser;
        }
    }

    /** @param maxima of a map of one layer */
    BlockPyramid(VoxelMaxima maxima) {
        double[] finest = new double[maxima.columns() * maxima.rows()];
        for (int at = 0; at < finest.length; at++) {
            finest[at] = maxima.perMetre(at % maxima.columns(), 0, at / maxima.columns());
        }
        Level level = new Level(finest, maxima.columns(), maxima.rows());
        levels.add(level);
        while (level.columns * level.rows > 1) {
            level = level.coarser();
            levels.add(level);
        }
    }

    int columns() {
        return levels.get(0).columns;
    }

    int rows() {
        return levels.get(0).rows;
    }

    double greatestOfAll() {
        return levels.get(levels.size() - 1).at(0, 0);
    }

    /** Returns an upper bound of a rectangle of blocks, the last ones included; behind the last block follows the first. */
    double greatest(long firstI, long firstK, long lastI, long lastK) {
        int i = (int) Math.floorMod(firstI, (long) columns());
        int k = (int) Math.floorMod(firstK, (long) rows());
        int lastColumn = i + (int) Math.min(columns() - 1, lastI - firstI);
        int lastRow = k + (int) Math.min(rows() - 1, lastK - firstK);
        double greatest = unwrapped(i, k, lastColumn, lastRow);
        boolean beginsAgain = lastColumn >= columns();
        if (beginsAgain) {
            greatest = Math.max(greatest, unwrapped(0, k, lastColumn - columns(), lastRow));
        }
        if (lastRow >= rows()) {
            greatest = Math.max(greatest, unwrapped(i, 0, lastColumn, lastRow - rows()));
        }
        if (beginsAgain && lastRow >= rows()) {
            greatest = Math.max(greatest, unwrapped(0, 0, lastColumn - columns(), lastRow - rows()));
        }
        return greatest;
    }

    /** Returns an upper bound of the part of a rectangle that is in the map. */
    private double unwrapped(int firstI, int firstK, int lastI, int lastK) {
        int toI = Math.min(lastI, columns() - 1);
        int toK = Math.min(lastK, rows() - 1);
        int widest = Math.max(toI - firstI, toK - firstK) / EXACT;
        int halvings = Integer.SIZE - Integer.numberOfLeadingZeros(widest);
        Level level = levels.get(Math.min(halvings, levels.size() - 1));
        double greatest = 0;
        for (int k = firstK >> halvings; k <= toK >> halvings; k++) {
            for (int i = firstI >> halvings; i <= toI >> halvings; i++) {
                greatest = Math.max(greatest, level.at(i, k));
            }
        }
        return greatest;
    }
}
