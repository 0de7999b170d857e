package nephele.engine.measure;

import java.util.List;

/** Errors of pictures that FLIP does not show: squared errors, bias of the mean, shimmer and overshoot. */
public final class ImageError {
    /** Limits the weight of black reference pixels; in squared radiance. */
    private static final double FLOOR = 1e-2;

    private static final int RGBA = 4;
    private static final int RGB = 3;

    private ImageError() {}

    /**
     * Returns the mean of (test − reference)² / (reference² + 0.01) over pixels and channels (Rousselle et al. 2011).
     */
    public static double relativeSquared(LinearPicture reference, LinearPicture test) {
        reference.requireSameSize(test);
        double sum = 0;
        for (int i = 0; i < reference.rgb().length; i++) {
            double exact = reference.rgb()[i];
            double difference = test.rgb()[i] - exact;
            sum += difference * difference / (exact * exact + FLOOR);
        }
        return sum / reference.rgb().length;
    }

    /** Returns the ratio of the mean luminances of test and reference, minus 1; 0 if both are black. */
    public static double meanBias(LinearPicture reference, LinearPicture test) {
        reference.requireSameSize(test);
        double exact = meanLuminance(reference);
        double tried = meanLuminance(test);
        return exact == tried ? 0 : tried / exact - 1;
    }

    /**
     * Returns √(mean (test − reference)²) over the channels of some pixels; 0 if there are none.
     *
     * @param counts for each pixel whether it counts
     */
    public static double rootMeanSquare(LinearPicture reference, LinearPicture test, boolean[] counts) {
        reference.requireSameSize(test);
        double sum = 0;
        int values = 0;
        for (int i = 0; i < reference.rgb().length; i++) {
            if (counts[i / 3]) {
                double difference = test.rgb()[i] - reference.rgb()[i];
                sum += difference * difference;
                values++;
            }
        }
        return values == 0 ? 0 : Math.sqrt(sum / values);
    }

    private static double meanLuminance(LinearPicture picture) {
        double sum = 0;
        for (int i = 0; i < picture.pixels(); i++) {
            sum += picture.luminance(i);
        }
        return sum / picture.pixels();
    }

    /**
     * Returns the flicker of the error along a moving picture, as edges that crawl over pixels in steps have it: the RMS
     * change of the error from frame to frame,
     * √(mean ((xₜ − rₜ) − (xₜ₋₁ − rₜ₋₁))²) over all channels, pixels and pairs of successive frames. An error that stays
     * does not count.
     *
     * @param reference the exact frames r, linear light
     * @param test the judged frames x, as many and of the same size
     */
    public static double shimmer(List<LinearPicture> reference, List<LinearPicture> test) {
        if (reference.size() != test.size() || test.size() < 2) {
            throw new IllegalArgumentException("shimmer is measured between the frames of two pictures, not of "
                    + reference.size() + " and " + test.size() + " frames");
        }
        double sum = 0;
        float[] before = error(reference.get(0), test.get(0));
        for (int frame = 1; frame < test.size(); frame++) {
            float[] now = error(reference.get(frame), test.get(frame));
            for (int i = 0; i < now.length; i++) {
                double change = now[i] - before[i];
                sum += change * change;
            }
            before = now;
        }
        return Math.sqrt(sum / before.length / (test.size() - 1));
    }

    private static float[] error(LinearPicture reference, LinearPicture test) {
        reference.requireSameSize(test);
        float[] error = new float[test.rgb().length];
        for (int i = 0; i < error.length; i++) {
            error[i] = test.rgb()[i] - reference.rgb()[i];
        }
        return error;
    }

    /**
     * Returns the halos of a filter: the greatest distance of a value from the range of the exact picture's values around it, in codes of 8 bits.
     *
     * @param exact RGBA
     * @param test likewise, of the same size
     * @param reach half the side of the square of pixels around a pixel
     */
    public static int overshoot(byte[] exact, byte[] test, int width, int reach) {
        int most = 0;
        for (int channel = 0; channel < RGB; channel++) {
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
        int[] values = new int[rgba.length / RGBA];
        for (int i = 0; i < values.length; i++) {
            values[i] = rgba[RGBA * i + channel] & 255;
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
