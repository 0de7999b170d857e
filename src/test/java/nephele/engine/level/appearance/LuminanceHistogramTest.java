package nephele.engine.level.appearance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The mean of the histogram is the log2 luminance of what is neither among the darkest nor the brightest. */
@Execution(ExecutionMode.CONCURRENT)
class LuminanceHistogramTest {
    private static final int WIDTH = 320;
    private static final int HEIGHT = 180;

    private static final double BIN_PRECISION =
            0.5 / (LuminanceHistogram.STEPS * LuminanceHistogram.BINS_PER_STOP) + 1e-9;

    private static float[] grey(double... values) {
        float[] rgb = new float[3 * values.length];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = (float) values[i / 3];
        }
        return rgb;
    }

    private static double[] even(double value) {
        double[] values = new double[WIDTH * HEIGHT];
        Arrays.fill(values, value);
        return values;
    }

    private static double mean(float[] rgb, int width) {
        return LuminanceHistogram.of(rgb, width).meanLog2();
    }

    private static double log2(double value) {
        return Math.log(value) / Math.log(2);
    }

    @Test
    void anEvenPicturesMeanIsItsLuminance() {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 50; i++) {
            double log2 = -24 + 40 * random.nextDouble();
            double value = Math.min((float) Math.pow(2, log2), 65504);
            assertEquals(log2(value), mean(grey(even(value)), WIDTH), BIN_PRECISION, "2^" + log2);
        }
    }

    @Test
    void coloursCountByTheirLuminance() {
        float[] rgb = {0.5f, 0.25f, 2};
        assertEquals(log2(0.2126 * 0.5 + 0.7152 * 0.25 + 0.0722 * 2), mean(rgb, 1), BIN_PRECISION);
    }

    /** Twice the light moves all cells by whole bins: the mean by one stop exactly. */
    @Test
    void twiceTheLightIsOneStopMore() {
        double[] values = ramp(WIDTH, HEIGHT);
        double one = mean(grey(values), WIDTH);
        double two = mean(grey(Arrays.stream(values).map(value -> 2 * value).toArray()), WIDTH);
        assertEquals(one + 1, two, 1e-9);
    }

    private static double[] ramp(int width, int height) {
        double[] values = new double[width * height];
        for (int i = 0; i < values.length; i++) {
            double x = (i % width + 0.5) / width;
            double y = (i / width + 0.5) / height;
            values[i] = Math.pow(2, -8 + 6 * x + 3 * y);
        }
        return values;
    }

    @ParameterizedTest
    @CsvSource({"64, 36", "1280, 720", "100, 333", "37, 11"})
    void theNumberOfPixelsDoesNotMatter(int width, int height) {
        double expected = mean(grey(ramp(WIDTH, HEIGHT)), WIDTH);
        assertEquals(expected, mean(grey(ramp(width, height)), width), width < 64 ? 0.25 : 0.05);
    }

    @Test
    void onePixelIsAPicture() {
        assertEquals(-3, mean(grey(0.125), 1), 1e-9);
    }

    /** A disc that fills 2 % of the picture and is brighter than anything else leaves the mean where it was. */
    @Test
    void theSunsDiscDoesNotCount() {
        double[] values = even(0.2);
        double before = mean(grey(values), WIDTH);
        double radius = Math.sqrt(0.02 * WIDTH * HEIGHT / Math.PI);
        for (int i = 0; i < values.length; i++) {
            double away = Math.hypot(i % WIDTH - 100, i / WIDTH - 60);
            values[i] = away < radius ? 65504 : values[i];
        }
        assertEquals(before, mean(grey(values), WIDTH), 0.01);
    }

    @Test
    void shadowsDoNotCount() {
        double[] values = even(0.2);
        double before = mean(grey(values), WIDTH);
        Arrays.fill(values, 0, (int) (0.48 * values.length), 1e-5);
        assertEquals(before, mean(grey(values), WIDTH), 0.01);
    }

    /** Bins with nothing but a number of cells would make it jump by their width, an eighth of a stop. */
    @Test
    void aSlowChangeOfLightNeverMakesTheMeanJump() {
        double last = Double.NaN;
        for (double value = 0.1; value < 0.25; value *= 1.003) {
            double now = mean(grey(value, 2 * value, value, value), 2);
            if (!Double.isNaN(last)) {
                assertTrue(now >= last && now - last < 0.01, value + ": from " + last + " to " + now);
            }
            last = now;
        }
    }

    @Test
    void aBlackPictureHasNoMean() {
        LuminanceHistogram black = LuminanceHistogram.of(grey(even(0)), WIDTH);
        assertTrue(Double.isNaN(black.meanLog2()) && !black.hasHidden());
    }

    @Test
    void pixelsThatAreNoNumbersAreLeftOut() {
        double[] values = even(0.2);
        double before = mean(grey(values), WIDTH);
        double[] bad = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int i = 0; i < values.length / 3; i++) {
            values[i] = bad[i % 3];
        }
        assertEquals(before, mean(grey(values), WIDTH), 1e-9);
        LuminanceHistogram none = LuminanceHistogram.of(grey(even(Double.NaN)), WIDTH);
        assertTrue(Double.isNaN(none.meanLog2()) && none.hasHidden());
    }
}
