package nephele.engine.asset;

/**
 * Heights as a file stores them, brought to 16 bits: 0 is the least, 65535 the greatest value of any file.
 *
 * @param bits of the file's values, 8 or 16
 * @param values rows from the top, samples from the left; unsigned
 */
public record HeightMap(int columns, int rows, int bits, short[] values) {
    /** The greatest value. */
    public static final int FULL_SCALE = 65535;

    /** The most samples along a side. */
    public static final int MOST_SAMPLES = 8193;

    /** The least samples along a side. */
    public static final int LEAST_SAMPLES = 2;

    /** Returns a value, 0 to {@link #FULL_SCALE}. */
    public int value(int column, int row) {
        return values[row * columns + column] & 0xffff;
    }
}
