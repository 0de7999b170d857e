package nephele.engine.level.appearance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The exposure that a picture calls for, and its approach in simulated time. */
class AutoExposureTest {
    private static double stops(double luminance) {
        float value = (float) luminance;
        return AutoExposure.stops(LuminanceHistogram.of(new float[] {value, value, value}, 1), AutoExposure.MOST_STOPS);
    }

    /** Returns the linear display value, before the tone curve, of a picture of one luminance. */
    private static double shown(double luminance) {
        return luminance * Math.pow(2, stops(luminance));
    }

    /** By hand from the formula, for 1 and 10 000 cd/m². */
    @Test
    void theKeyIsKrawczyks() {
        assertEquals(1.03 - 2 / (2 + 0.30103), AutoExposure.key(Math.log(1e-4) / Math.log(2)), 1e-6);
        assertEquals(1.03 - 2 / (2 + 4.0000434), AutoExposure.key(0), 1e-6);
    }

    /** The sunlit ground and the sky at noon, and the night's own glow. */
    @Test
    void dayIsShownGreyAndNightDark() {
        assertEquals(0.27, shown(0.3), 0.01);
        assertTrue(shown(2e-5) < 0.03, "night " + shown(2e-5));
    }

    /** Darker pictures are shown darker, but by less than they are. */
    @Test
    void theDisplayFollowsTheLightPartOfTheWay() {
        double last = shown(1e-3);
        for (double luminance = 2e-3; luminance < 100; luminance *= 2) {
            double now = shown(luminance);
            assertTrue(now > last && now < 2 * last, luminance + ": " + last + ", " + now);
            last = now;
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 12", "1e-7, 12", "65504, -16", "1e30, -16"})
    void theStopsHaveLimits(double luminance, double expected) {
        assertEquals(expected, stops(luminance));
    }

    /** A picture of which nothing can be metered keeps what it had; a black one does not. */
    @Test
    void whatIsHiddenHolds() {
        LuminanceHistogram hidden = LuminanceHistogram.of(new float[] {Float.NaN, 0, 0}, 1);
        assertEquals(3.5, AutoExposure.stops(hidden, 3.5));
        LuminanceHistogram black = LuminanceHistogram.of(new float[3], 1);
        assertEquals(AutoExposure.MOST_STOPS, AutoExposure.stops(black, 3.5));
    }

    /** One second is as long as a hundred hundredths, as 120 ticks, and as frames of any length. */
    @ParameterizedTest
    @ValueSource(ints = {2, 7, 100, 120, 1000})
    void framesDoNotMatter(int steps) {
        for (double target : new double[] {-6, 9}) {
            double stops = 1.5;
            for (int i = 0; i < steps; i++) {
                stops = AutoExposure.adapted(stops, target, 1.0 / steps);
            }
            assertEquals(AutoExposure.adapted(1.5, target, 1), stops, 1e-12);
        }
    }

    @Test
    void noTimeChangesNothingAndMuchTimeConverges() {
        assertEquals(1.5, AutoExposure.adapted(1.5, 9, 0));
        assertEquals(9, AutoExposure.adapted(1.5, 9, 1e9));
        assertEquals(-6, AutoExposure.adapted(1.5, -6, 1e9));
    }

    @Test
    void theEyeIsSoonerUsedToLightThanToDark() {
        double toLight = AutoExposure.adapted(4, 0, 0.5);
        double toDark = AutoExposure.adapted(0, 4, 0.5);
        assertTrue(toLight > 0 && toLight < 4 - toDark, toLight + ", " + toDark);
    }
}
