package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Exit;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.ToneCurve;
import nephele.engine.level.appearance.AutoExposure;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.LuminanceHistogram;
import nephele.engine.level.placed.NoFiles;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** The exposure that a traced picture calls for does not depend on the curtains in it. */
class TracedExposureTest {
    private static final Pinhole EYE = new Pinhole(
            Vec3.ZERO, new Basis(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1)), 1, 0.6, 0.05, 1000);

    private static TestLevel level(double light) {
        return new TestLevel()
                .autoExposure()
                .sky(new Sky.Constant(TestLevel.grey(light)))
                .exit(new Exit("exit", new Vec3(0, -1, -3), 1, 2.5));
    }

    private static PlacedLevel fixed(TestLevel level) {
        return TracedExposure.fixed(PlacedLevel.of(level.level(), NoFiles.AT_ALL), ColourDecoding.SRGB, EYE, 0);
    }

    @Test
    void theLightOfTheSceneDecides() {
        for (double light : new double[] {3e-4, 0.3}) {
            float[] even = {(float) light, (float) light, (float) light};
            double expected = AutoExposure.stops(LuminanceHistogram.of(even, 1), AutoExposure.MOST_STOPS);
            assertEquals(
                    expected,
                    fixed(level(light)).level().environment().exposureStops().fixedStops(),
                    1e-3);
        }
    }

    /** The curtain adds the same to the display at every exposure. */
    @Test
    void theCurtainIsTracedForThatExposure() {
        double[] shown = new double[2];
        for (int i = 0; i < 2; i++) {
            double light = i == 0 ? 3e-4 : 0.3;
            PlacedLevel level = fixed(level(light));
            float[] rgb = ReferencePicture.trace(
                    TracedLevel.of(level, ColourDecoding.SRGB), EYE, new TraceSettings(1, 1, 1, 1, 1), share -> {});
            double stops = level.level().environment().exposureStops().fixedStops();
            shown[i] = (rgb[0] - light) * Math.pow(2, stops);
        }
        assertTrue(shown[0] > 0.05, "curtain " + shown[0]);
        assertEquals(shown[0], shown[1], 1e-3);
    }

    /** The wind takes an opaque black cloud away from the eye. */
    @Test
    void thePictureOfTheTimeIsMetered() {
        var extent = new Cloud.Extent.Volume(new Vec3(0, 0, -300), new Vec3(500, 500, 500));
        var wind = new Cloud.Motion(new Vec3(100, 0, 0), 0);
        var black = new Cloud("c", extent, CloudTechnique.AUTO, new Cloud.Density.Ellipsoid(), 1, 0, 0, wind);
        PlacedLevel placed = PlacedLevel.of(level(0.3).cloud(black).level(), NoFiles.AT_ALL);
        float[] even = {0.3f, 0.3f, 0.3f};
        double gone = AutoExposure.stops(LuminanceHistogram.of(even, 1), AutoExposure.MOST_STOPS);
        assertEquals(gone, stops(TracedExposure.fixed(placed, ColourDecoding.SRGB, EYE, 60)), 1e-3);
        assertTrue(stops(TracedExposure.fixed(placed, ColourDecoding.SRGB, EYE, 0)) > gone + 1);
    }

    private static double stops(PlacedLevel level) {
        return level.level().environment().exposureStops().fixedStops();
    }

    @Test
    void stopsInTheLevelStay() {
        PlacedLevel placed =
                PlacedLevel.of(level(1).toneMapping(ToneCurve.CLIP, 2).level(), NoFiles.AT_ALL);
        assertSame(placed, TracedExposure.fixed(placed, ColourDecoding.SRGB, EYE, 0));
        assertFalse(TracedExposure.isNeeded(placed.level()));
    }
}
