package nephele.engine.math.heightfield;

import java.util.Arrays;

/** A rectangle of a grid's samples; the ends count. */
public record SampleRange(int firstColumn, int firstRow, int lastColumn, int lastRow) {
    /** No samples. */
    public static final SampleRange NONE = new SampleRange(0, 0, -1, -1);

    /** Returns the smallest range with all samples that differ between two grids of the same size. */
    static SampleRange differing(float[] some, float[] others, int columns) {
        int[] ends = {columns, some.length / columns, -1, -1};
        for (int row = 0; row < some.length / columns; row++) {
            int from = row * columns;
            int first = Arrays.mismatch(some, from, from + columns, others, from, from + columns);
            if (first >= 0) {
                int last = columns - 1;
                while (last > first && some[from + last] == others[from + last]) {
                    last--;
                }
                ends[0] = Math.min(ends[0], first);
                ends[1] = Math.min(ends[1], row);
                ends[2] = Math.max(ends[2], last);
                ends[3] = row;
            }
        }
        return ends[3] < 0 ? NONE : new SampleRange(ends[0], ends[1], ends[2], ends[3]);
    }

    public boolean isEmpty() {
        return lastColumn < firstColumn || lastRow < firstRow;
    }

    public int columns() {
        return lastColumn - firstColumn + 1;
    }

    public int rows() {
        return lastRow - firstRow + 1;
    }

    /** Returns the number of samples. */
    public long count() {
        return isEmpty() ? 0 : (long) columns() * rows();
    }

    /** Returns the smallest range that holds both; neither is empty. */
    public SampleRange union(SampleRange other) {
        return new SampleRange(
                Math.min(firstColumn, other.firstColumn),
                Math.min(firstRow, other.firstRow),
                Math.max(lastColumn, other.lastColumn),
                Math.max(lastRow, other.lastRow));
    }

    /** Returns the samples of both. */
    public SampleRange intersection(SampleRange other) {
        return new SampleRange(
                Math.max(firstColumn, other.firstColumn),
                Math.max(firstRow, other.firstRow),
                Math.min(lastColumn, other.lastColumn),
                Math.min(lastRow, other.lastRow));
    }

    /** Returns this range with so many samples more on each side. */
    public SampleRange grown(int samples) {
        return isEmpty()
                ? this
                : new SampleRange(firstColumn - samples, firstRow - samples, lastColumn + samples, lastRow + samples);
    }
}
