package nephele.engine.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** FLIP agrees with its authors' evaluator 1.7, and with answers known by other means. */
class FlipTest {
    /** Both agree to single precision. */
    private static final double TOLERANCE = 1e-5;

    private static final int[][] ROW_AND_COLUMN = {{0, 0}, {45, 80}, {20, 33}, {60, 120}, {89, 159}};

    @ParameterizedTest
    @ValueSource(strings = {"courtyard", "lamps", "portals"})
    void agreesWithTheEvaluator(String pair) throws IOException {
        double[] figures = figures(pair);
        var reference = Pfm.resource(pair + "-reference.pfm");
        var test = Pfm.resource(pair + "-test.pfm");
        var exposures = HdrFlip.ExposureRange.of(reference);
        assertEquals(figures[0], exposures.startStops(), TOLERANCE);
        assertEquals(figures[1], exposures.stopStops(), TOLERANCE);
        assertEquals((int) figures[2], exposures.count());
        var map = HdrFlip.of(reference, test);
        assertEquals(figures[3], map.mean(), TOLERANCE);
        for (int i = 0; i < ROW_AND_COLUMN.length; i++) {
            float error = map.error()[ROW_AND_COLUMN[i][0] * map.width() + ROW_AND_COLUMN[i][1]];
            assertEquals(figures[4 + i], error, TOLERANCE, "pixel " + i);
        }
        assertEquals(
                figures[9], Flip.ofDisplayed(clipped(reference), clipped(test)).mean(), TOLERANCE);
    }

    @Test
    void equalPicturesHaveNoErrorAndBlackAgainstWhiteTheGreatest() {
        var grey = even(20, 20, 0.3f);
        assertEquals(0, HdrFlip.of(grey, grey).quantile(1));
        double most = Flip.ofDisplayed(even(20, 20, 0), even(20, 20, 1)).mean();
        assertTrue(most > 0.9 && most <= 1, "black against white: " + most);
    }

    @Test
    void measuresTheSameForwardsAndBackwards() throws IOException {
        var a = clipped(Pfm.resource("lamps-reference.pfm"));
        var b = clipped(Pfm.resource("lamps-test.pfm"));
        assertEquals(Flip.ofDisplayed(a, b).mean(), Flip.ofDisplayed(b, a).mean(), 1e-7);
    }

    /** The error grows with the difference, from invisible (a thousandth of light) to visible (a tenth). */
    @Test
    void growsWithTheDifference() {
        var exact = even(16, 16, 0.5f);
        double before = 0;
        for (float step : new float[] {0.001f, 0.01f, 0.1f, 0.4f}) {
            double error = HdrFlip.of(exact, even(16, 16, 0.5f + step)).mean();
            assertTrue(error > before, step + ": " + error);
            before = error;
        }
    }

    @Test
    void blackAndEvenReferencesHaveExposures() {
        for (float radiance : new float[] {0, 1e-30f, 1, 60_000}) {
            var exposures = HdrFlip.ExposureRange.of(even(4, 4, radiance));
            assertEquals(2, exposures.count());
            assertTrue(Double.isFinite(exposures.startStops()) && exposures.startStops() <= exposures.stopStops());
            assertEquals(
                    0, HdrFlip.of(even(4, 4, radiance), even(4, 4, radiance)).mean());
        }
    }

    @Test
    void refusesWhatCannotBeCompared() {
        var nan = assertThrows(IllegalArgumentException.class, () -> even(3, 2, Float.NaN));
        assertTrue(nan.getMessage().contains("pixel 0,0"), nan.getMessage());
        assertThrows(IllegalArgumentException.class, () -> HdrFlip.of(even(3, 2, 1), even(2, 3, 1)));
        assertThrows(IllegalArgumentException.class, () -> new LinearPicture(2, 2, new float[11]));
    }

    private static LinearPicture even(int width, int height, float value) {
        float[] rgb = new float[3 * width * height];
        java.util.Arrays.fill(rgb, value);
        return new LinearPicture(width, height, rgb);
    }

    private static LinearPicture clipped(LinearPicture picture) {
        float[] rgb = picture.rgb().clone();
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = Math.min(Math.max(rgb[i], 0), 1);
        }
        return new LinearPicture(picture.width(), picture.height(), rgb);
    }

    private static double[] figures(String pair) throws IOException {
        try (var in = FlipTest.class.getResourceAsStream("figures.csv")) {
            return new String(in.readAllBytes(), StandardCharsets.US_ASCII)
                    .lines()
                    .filter(line -> line.startsWith(pair + ","))
                    .flatMapToDouble(line ->
                            java.util.Arrays.stream(line.split(",")).skip(1).mapToDouble(Double::parseDouble))
                    .toArray();
        }
    }
}
