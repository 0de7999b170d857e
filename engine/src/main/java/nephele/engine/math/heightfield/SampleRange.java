package nephele.engine.math.heightfield;

/** A rectangle of a grid's samples; the ends count. */
public record SampleRange(int firstColumn, int firstRow, int lastColumn, int lastRow) {
    /** No samples. */
    public static final SampleRange NONE = new SampleRange(0, 0, -1, -1);

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

    /** Returns true if this has a sample within other ends, which count. */
    public boolean touches(int fromColumn, int fromRow, int toColumn, int toRow) {
        return !isEmpty()
                && firstColumn <= toColumn
                && lastColumn >= fromColumn
                && firstRow <= toRow
                && lastRow >= fromRow;
    }

    /** Returns this range with so many samples more on each side. */
    public SampleRange grown(int samples) {
        return isEmpty()
                ? this
                : new SampleRange(firstColumn - samples, firstRow - samples, lastColumn + samples, lastRow + samples);
    }
}
