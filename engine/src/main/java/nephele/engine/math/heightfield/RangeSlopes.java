package nephele.engine.math.heightfield;

import java.util.function.IntToDoubleFunction;

/**
 * Raises the ranges of tiles until neighbours, also diagonal ones, differ by a factor at most. Tiles that are never drawn
 * coarser keep their range and raise no other; what touches them gets a range of its own.
 */
final class RangeSlopes {
    private final int columns;
    private final int rows;
    private final double[] ranges;
    private final boolean[] isNever;

    RangeSlopes(int columns, int rows, double[] ranges, boolean[] isNever) {
        this.columns = columns;
        this.rows = rows;
        this.ranges = ranges;
        this.isNever = isNever;
    }

    void limit(double factor, IntToDoubleFunction besideNever) {
        for (int at = 0; at < ranges.length; at++) {
            if (!isNever[at] && touchesNever(at)) {
                ranges[at] = Math.max(ranges[at], besideNever.applyAsDouble(at));
            }
        }
        for (int at = 0; at < ranges.length; at++) {
            raise(at, -1, factor);
        }
        for (int at = ranges.length - 1; at >= 0; at--) {
            raise(at, 1, factor);
        }
    }

    private boolean touchesNever(int at) {
        for (int neighbour = 0; neighbour < 9; neighbour++) {
            int other = neighbour(at, neighbour % 3 - 1, neighbour / 3 - 1);
            if (other >= 0 && isNever[other]) {
                return true;
            }
        }
        return false;
    }

    /** Raises a tile to what four of its neighbours require: those before it, or after it, in row-major order. */
    private void raise(int at, int sign, double factor) {
        if (isNever[at]) {
            return;
        }
        for (int x = -1; x <= 1; x++) {
            follow(at, neighbour(at, x, sign), factor);
        }
        follow(at, neighbour(at, sign, 0), factor);
    }

    private void follow(int at, int other, double factor) {
        if (other >= 0 && !isNever[other]) {
            ranges[at] = Math.max(ranges[at], ranges[other] / factor);
        }
    }

    private int neighbour(int at, int x, int z) {
        int column = at % columns + x;
        int row = at / columns + z;
        return column < 0 || row < 0 || column >= columns || row >= rows ? -1 : row * columns + column;
    }
}
