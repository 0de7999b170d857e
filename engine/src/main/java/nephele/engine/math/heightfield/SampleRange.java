package nephele.engine.math.heightfield;

/** A rectangle of a grid's samples; the ends count. */
public record SampleRange(int firstColumn, int firstRow, int lastColumn, int lastRow) {
    /** No samples. */
    public static final SampleRange NONE = new SampleRange(0, 0, -1, -1);

    public boolean isEmpty() {
        return lastColumn < firstColumn || lastRow < firstRow;
    }

    /** Returns the number of samples. */
    public long count() {
        return isEmpty() ? 0 : (lastColumn - firstColumn + 1L) * (lastRow - firstRow + 1L);
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
