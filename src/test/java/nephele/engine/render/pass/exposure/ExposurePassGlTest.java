package nephele.engine.render.pass.exposure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import nephele.engine.level.appearance.AutoExposure;
import nephele.engine.level.appearance.LuminanceHistogram;
import nephele.engine.render.gl.GlContext;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The pass meters any picture as its twin does, and adapts in simulated time. */
class ExposurePassGlTest {
    private static final int WIDTH = 96;
    private static final int HEIGHT = 54;

    /** The exponential functions of 32 bits, and radiance rounded to half floats. */
    private static final double TWIN_STOPS = 2e-3;

    private static float[] even(float value) {
        float[] rgb = new float[3 * WIDTH * HEIGHT];
        Arrays.fill(rgb, value);
        return rgb;
    }

    private static double twin(float[] rgb, int width) {
        return AutoExposure.stops(LuminanceHistogram.of(rgb, width), AutoExposure.MOST_STOPS);
    }

    /** Returns a picture of patches of any luminance and colour, black ones too. */
    private static float[] patches(SplittableRandom random, int width, int height) {
        float[] rgb = new float[3 * width * height];
        double darkest = -18 + 20 * random.nextDouble();
        for (int patch = 0; patch < 40; patch++) {
            double luminance = random.nextInt(6) == 0 ? 0 : Math.pow(2, darkest + 12 * random.nextDouble());
            int left = random.nextInt(width);
            int bottom = random.nextInt(height);
            for (int y = bottom; y < Math.min(height, bottom + height / 2 + 1); y++) {
                for (int x = left; x < Math.min(width, left + width / 3 + 1); x++) {
                    for (int channel = 0; channel < 3; channel++) {
                        rgb[3 * (y * width + x) + channel] = (float) (luminance * (channel + 1) / 2);
                    }
                }
            }
        }
        return rgb;
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "3, 2", "64, 36", "96, 54", "213, 119"})
    void anyPictureIsMeteredAsByTheTwin(int width, int height) {
        SplittableRandom random = new SplittableRandom(7);
        try (GlContext gl = GlContext.offscreen();
                MeteredPicture metered = new MeteredPicture(gl, width, height)) {
            for (int i = 0; i < 12; i++) {
                float[] rgb = patches(random, width, height);
                metered.exposure().forget();
                assertEquals(twin(rgb, width), metered.stops(rgb, 0), TWIN_STOPS, "picture " + i);
            }
            gl.requireNoError("metering");
        }
    }

    @Test
    void itAdaptsAsTheTwinDoes() {
        try (GlContext gl = GlContext.offscreen();
                MeteredPicture metered = new MeteredPicture(gl, WIDTH, HEIGHT)) {
            double stops = metered.stops(even(0.3f), 0);
            double seconds = 0;
            for (float light : new float[] {0.3f, 20, 20, 0.001f, 0.001f, 5}) {
                stops = AutoExposure.adapted(stops, twin(even(light), WIDTH), 0.4);
                seconds += 0.4;
                assertEquals(stops, metered.stops(even(light), seconds), TWIN_STOPS, "after " + seconds + " s");
            }
        }
    }

    /** A step of a second, and a hundred of 10 ms, end within 1e-4 stops. */
    @Test
    void theNumberOfFramesDoesNotMatter() {
        try (GlContext gl = GlContext.offscreen();
                MeteredPicture metered = new MeteredPicture(gl, WIDTH, HEIGHT)) {
            for (float light : new float[] {0.0002f, 50}) {
                metered.exposure().forget();
                metered.stops(even(0.3f), 0);
                double once = metered.stops(even(light), 1);
                metered.exposure().forget();
                metered.stops(even(0.3f), 0);
                double often = 0;
                for (int frame = 1; frame <= 100; frame++) {
                    often = metered.stops(even(light), frame / 100.0);
                }
                assertEquals(once, often, 1e-4);
            }
        }
    }

    @Test
    void noTimeChangesNothingAndMuchTimeConverges() {
        try (GlContext gl = GlContext.offscreen();
                MeteredPicture metered = new MeteredPicture(gl, WIDTH, HEIGHT)) {
            double first = metered.stops(even(0.3f), 2);
            assertEquals(first, metered.stops(even(40), 2));
            assertEquals(twin(even(40), WIDTH), metered.stops(even(40), 1e6), TWIN_STOPS);
        }
    }

    /** Without history a picture has exactly the exposure that its own brightness gives, whatever was shown before. */
    @Test
    void afterACutNothingIsLeftOfThePictureBefore() {
        try (GlContext gl = GlContext.offscreen();
                MeteredPicture cold = new MeteredPicture(gl, WIDTH, HEIGHT);
                MeteredPicture warm = new MeteredPicture(gl, WIDTH, HEIGHT)) {
            double expected = cold.stops(even(0.01f), 7);
            warm.stops(even(3000), 6.9);
            warm.exposure().forget();
            assertEquals(expected, warm.stops(even(0.01f), 7), "forgotten");
            warm.stops(even(3000), 100);
            assertEquals(expected, warm.stops(even(0.01f), 7), "time went back");
        }
    }

    @Test
    void theStopsHaveLimits() {
        try (GlContext gl = GlContext.offscreen();
                MeteredPicture metered = new MeteredPicture(gl, WIDTH, HEIGHT)) {
            assertEquals(AutoExposure.MOST_STOPS, metered.stops(even(0), 0), "black");
            metered.exposure().forget();
            assertEquals(AutoExposure.LEAST_STOPS, metered.stops(even(65504), 0), "as bright as can be");
            assertEquals(AutoExposure.MOST_STOPS, metered.stops(even(0), 1e6), 1e-4, "the light goes out");
        }
    }

    /** A pixel that is no number is left out; nothing of it stays in the history. */
    @Test
    void noPixelPoisonsTheHistory() {
        try (GlContext gl = GlContext.offscreen();
                MeteredPicture metered = new MeteredPicture(gl, WIDTH, HEIGHT)) {
            double expected = metered.stops(even(0.3f), 0);
            float[] bad = even(0.3f);
            float[] notNumbers = {Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY};
            for (int i = 0; i < bad.length / 2; i += 2) {
                bad[i] = notNumbers[i % 3];
            }
            assertEquals(expected, metered.stops(bad, 1), 1e-6, "a part");
            assertEquals(expected, metered.stops(even(Float.NaN), 2), 1e-6, "all");
            assertEquals(expected, metered.stops(even(0.3f), 3), 1e-6, "afterwards");
        }
    }

    /** Display values in the scene have a share below 1: they do not count, and alone they change nothing. */
    @Test
    void whatIsHiddenDoesNotCount() {
        try (GlContext gl = GlContext.offscreen();
                MeteredPicture metered = new MeteredPicture(gl, WIDTH, HEIGHT)) {
            double expected = metered.stops(even(0.3f), 0);
            float[] rgb = even(0.3f);
            float[] shares = new float[WIDTH * HEIGHT];
            Arrays.fill(shares, 1);
            Arrays.fill(rgb, 0, rgb.length / 2, 1000);
            Arrays.fill(shares, 0, shares.length / 2, 0.9f);
            assertEquals(expected, metered.stops(rgb, shares, 1e6), 1e-4);
            Arrays.fill(shares, 0);
            assertEquals(expected, metered.stops(rgb, shares, 2e6), 1e-4);
            assertTrue(metered.stops(rgb, 3e6) < expected - 5, "all of it counts");
        }
    }
}
