package nephele.engine.measure;

/** Halos of a filter: values beyond all values of the exact picture around them. */
public final class Overshoot {
    private static final int CHANNELS = 4;
    private static final int COLOURS = 3;

    private Overshoot() {}

    /**
     * Returns the greatest distance of a value from the range of the exact picture's values around it, in codes of 8 bits.
     *
     * @param exact RGBA
     * @param test likewise, of the same size
     * @param reach half the side of the square of pixels around a pixel
     */
    public static int codes(byte[] exact, byte[] test, int width, int reach) {
        int most = 0;
        for (int channel = 0; channel < COLOURS; channel++) {
            int[] values = channel(exact, channel);
            int[] upper = greatest(values, width, reach);
            int[] lower = greatest(negated(values), width, reach);
            int[] tried = channel(test, channel);
            for (int i = 0; i < tried.length; i++) {
                most = Math.max(most, Math.max(tried[i] - upper[i], -lower[i] - tried[i]));
            }
        }
        return most;
    }

    private static int[] channel(byte[] rgba, int channel) {
        int[] values = new int[rgba.length / CHANNELS];
        for (int i = 0; i < values.length; i++) {
            values[i] = rgba[CHANNELS * i + channel] & 255;
        }
        return values;
    }

    private static int[] negated(int[] values) {
        int[] negated = new int[values.length];
        for (int i = 0; i < values.length; i++) {
            negated[i] = -values[i];
        }
        return negated;
    }

    /** Returns the greatest value in the square around each pixel: along the rows, then along the columns. */
    private static int[] greatest(int[] values, int width, int reach) {
        int height = values.length / width;
        int[] rows = new int[values.length];
        int[] squares = new int[values.length];
        for (int i = 0; i < values.length; i++) {
            int x = i % width;
            int row = i - x;
            rows[i] = values[i];
            for (int near = Math.max(0, x - reach); near <= Math.min(width - 1, x + reach); near++) {
                rows[i] = Math.max(rows[i], values[row + near]);
            }
        }
        for (int i = 0; i < values.length; i++) {
            int y = i / width;
            int x = i % width;
            squares[i] = rows[i];
            for (int near = Math.max(0, y - reach); near <= Math.min(height - 1, y + reach); near++) {
                squares[i] = Math.max(squares[i], rows[near * width + x]);
            }
        }
        return squares;
    }
}
