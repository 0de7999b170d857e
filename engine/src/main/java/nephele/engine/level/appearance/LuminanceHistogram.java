package nephele.engine.level.appearance;

import java.util.stream.IntStream;
import nephele.engine.math.Vec3;

/**
 * Histogram of a picture's luminance, from which its exposure is metered. The picture is divided into {@value #COLUMNS} ×
 * {@value #ROWS} cells; a cell counts with the mean luminance of {@value #SAMPLES} × {@value #SAMPLES} pixels of it, so
 * that the mean does not depend on the number of pixels. Bins are equal steps of log2 luminance; each knows the number
 * and the mean of its cells, so that even light is metered exactly. The twin of the shaders of
 * {@code render.pass.exposure}.
 */
public final class LuminanceHistogram {
    public static final int COLUMNS = 64;
    public static final int ROWS = 36;

    /** Pixels along each side of a cell that are read. */
    public static final int SAMPLES = 6;

    /** Log2 luminance of the first bin, the smallest positive half float; less counts as black. */
    public static final int DARKEST_LOG2 = -24;

    public static final int BINS_PER_STOP = 8;

    /** Up to the largest half float, 2^16. */
    public static final int BINS = 40 * BINS_PER_STOP;

    /** Steps in a bin to which values are rounded: sums are whole numbers, whatever the order of additions. */
    public static final int STEPS = 256;

    /** Share of the cells, the darkest ones, that is left out: what is lit decides, not the shadows beside it. */
    public static final double LOW_SHARE = 0.5;

    /** Share of the cells up to the brightest ones, which are left out: the sun's disc, lamps, glints. */
    public static final double HIGH_SHARE = 0.97;

    /** The largest half float: radiance is bounded by it, since a light may be so near that half floats overflow. */
    public static final float LARGEST_HALF = 65504;

    /** Luminance of red, green and blue (ITU-R BT.709). */
    private static final Vec3 LUMINANCE = new Vec3(0.2126, 0.7152, 0.0722);

    private static final double LOG_2 = Math.log(2);

    private final int[] counts = new int[BINS];
    private final int[] sums = new int[BINS];
    private boolean hasHidden;

    private LuminanceHistogram() {}

    /**
     * Returns the histogram of a picture. Pixels that are not finite are hidden: they count nowhere.
     *
     * @param rgb linear radiance
     */
    public static LuminanceHistogram of(float[] rgb, int width) {
        LuminanceHistogram histogram = new LuminanceHistogram();
        int height = rgb.length / 3 / width;
        for (int row = 0; row < ROWS; row++) {
            for (int column = 0; column < COLUMNS; column++) {
                histogram.add(meanOfCell(rgb, width, height, column, row));
            }
        }
        return histogram;
    }

    /** Returns the mean luminance of the finite pixels of a cell that are read; NaN if there is none. */
    private static double meanOfCell(float[] rgb, int width, int height, int column, int row) {
        double sum = 0;
        int finite = 0;
        for (int i = 0; i < SAMPLES * SAMPLES; i++) {
            int x = pixel(SAMPLES * column + i % SAMPLES, SAMPLES * COLUMNS, width);
            int y = pixel(SAMPLES * row + i / SAMPLES, SAMPLES * ROWS, height);
            double luminance = luminance(rgb, 3 * (y * width + x));
            if (Double.isFinite(luminance)) {
                sum += luminance;
                finite++;
            }
        }
        return finite == 0 ? Double.NaN : sum / finite;
    }

    private static int pixel(int sample, int samples, int pixels) {
        return (2 * sample + 1) * pixels / (2 * samples);
    }

    /** Returns the luminance of what a linear picture of half floats holds. */
    private static double luminance(float[] rgb, int at) {
        double sum = LUMINANCE.x() * rgb[at] + LUMINANCE.y() * rgb[at + 1] + LUMINANCE.z() * rgb[at + 2];
        return Double.isFinite(sum)
                ? LUMINANCE.x() * held(rgb[at]) + LUMINANCE.y() * held(rgb[at + 1]) + LUMINANCE.z() * held(rgb[at + 2])
                : sum;
    }

    private static double held(float radiance) {
        return Math.min(Math.max(radiance, 0), LARGEST_HALF);
    }

    private void add(double luminance) {
        if (Double.isNaN(luminance)) {
            hasHidden = true;
            return;
        }
        double log2 = Math.log(luminance) / LOG_2;
        if (log2 < DARKEST_LOG2) {
            return;
        }
        double at = (log2 - DARKEST_LOG2) * BINS_PER_STOP;
        int bin = (int) Math.min(at, BINS - 1);
        counts[bin]++;
        sums[bin] += (int) Math.floor((at - bin) * STEPS + 0.5);
    }

    /** Returns true if a part of the picture is hidden. */
    public boolean hasHidden() {
        return hasHidden;
    }

    /** Returns the mean of log2 luminance between the two shares; NaN if nothing shines. */
    public double meanLog2() {
        int total = IntStream.of(counts).sum();
        double low = LOW_SHARE * total;
        double high = HIGH_SHARE * total;
        double below = 0;
        double sum = 0;
        for (int bin = 0; bin < BINS; bin++) {
            double within = Math.min(below + counts[bin], high) - Math.max(below, low);
            if (within > 0) {
                double mean = bin + (double) sums[bin] / (STEPS * counts[bin]);
                sum += within * (DARKEST_LOG2 + mean / BINS_PER_STOP);
            }
            below += counts[bin];
        }
        return total == 0 ? Double.NaN : sum / (high - low);
    }
}
