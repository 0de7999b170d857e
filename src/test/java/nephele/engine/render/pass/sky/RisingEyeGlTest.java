package nephele.engine.render.pass.sky;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.asset.TestAssets;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.frame.ToneMapping;
import nephele.engine.render.resource.HeightCache;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Eyes on both sides of the height at which another table begins see the same sky and ground, horizon included. */
class RisingEyeGlTest {
    private static final int SIDE = 48;
    private static final double MILLIMETRE = 1e-3;

    private static double boundary(double from) {
        double low = from;
        double high = 1.3 * from + 120;
        double shelf = HeightCache.shelf(from);
        while (high - low > MILLIMETRE / 2) {
            double middle = (low + high) / 2;
            if (HeightCache.shelf(middle) == shelf) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    private static View view(double height) {
        return View.lookAt(
                new Vec3(0, height, 0),
                new Vec3(0.3, height, -1),
                new Vec3(0, 1, 0),
                new Projection(Math.toRadians(8), 1, 0.05, 1e5));
    }

    @ParameterizedTest
    @CsvSource({"2, 10, -0.3", "9, 0.5, 2", "45, 10, -0.3", "1000, 3, 1"})
    void anotherTableChangesNoCodeByMoreThanTwo(double from, double sunDegrees, double stops) {
        double sun = Math.toRadians(sunDegrees);
        Level level = new TestLevel()
                .sky(Sky.Atmosphere.CLEAR)
                .sun(new Vec3(Math.cos(sun), Math.sin(sun), 0), 4)
                .level();
        double edge = boundary(from);
        assertTrue(HeightCache.shelf(edge - MILLIMETRE) < HeightCache.shelf(edge + MILLIMETRE), "two tables");
        try (Offscreen offscreen = new Offscreen(SIDE, SIDE)) {
            float[] below = offscreen.radiance(level, TestAssets.NONE, view(edge - MILLIMETRE));
            float[] above = offscreen.radiance(level, TestAssets.NONE, view(edge + MILLIMETRE));
            for (int i = 0; i < below.length; i++) {
                assertEquals(code(below[i], stops), code(above[i], stops), 2, "pixel " + i / 3 + " at " + edge + " m");
            }
        }
    }

    private static double code(double radiance, double stops) {
        return 255 * ToneMapping.displayValue(radiance, Math.pow(2, stops), ToneCurve.CLIP);
    }
}
