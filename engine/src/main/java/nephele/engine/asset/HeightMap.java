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

    /** By how much rougher than with exchanged bytes a map of exchanged bytes is at least. */
    private static final double ROUGHER = 4;

    /** Fewer samples along a side tell nothing. */
    private static final int LEAST_TOLD = 8;

    /** About as many samples are looked at. */
    private static final int LOOKED_AT = 1 << 20;

    /**
     * Returns true if the bytes of each value seem to be exchanged: the step from sample to sample, as a share of the
     * range, would be far smaller if they were. Noise, steps of 256 and values of 8 bits are equal either way.
     */
    public boolean seemsSwapped() {
        return bits == 16 && Math.min(columns, rows) >= LEAST_TOLD && roughness(false) > ROUGHER * roughness(true);
    }

    /** Returns the mean step between neighbours as a share of the range; 0 for a plane. */
    private double roughness(boolean isSwapped) {
        int stride = Math.max(1, values.length / LOOKED_AT);
        int least = FULL_SCALE;
        int most = 0;
        double steps = 0;
        long count = 0;
        for (int row = 0; row + 1 < rows; row += stride) {
            for (int column = 0; column + 1 < columns; column++) {
                int at = row * columns + column;
                int value = value(at, isSwapped);
                least = Math.min(least, value);
                most = Math.max(most, value);
                steps += Math.abs(value - value(at + 1, isSwapped)) + Math.abs(value - value(at + columns, isSwapped));
                count += 2;
            }
        }
        return most == least ? 0 : steps / count / (most - least);
    }

    private int value(int at, boolean isSwapped) {
        return (isSwapped ? Short.reverseBytes(values[at]) : values[at]) & 0xffff;
    }

    /** Returns a value, 0 to {@link #FULL_SCALE}. */
    public int value(int column, int row) {
        return values[row * columns + column] & 0xffff;
    }
}
