package nephele.engine.render.cloud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.CloudHistory;
import nephele.engine.scene.View;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Clouds in front of surfaces that stand among them look as if each pixel had a ray of its own, at edges too. */
@TestInstance(Lifecycle.PER_CLASS)
class SurfacesAmongCloudsGlTest {
    private static final Quality WHOLE =
            Quality.HIGH.with("cloudResolution", 1).with("cloudHistory", CloudHistory.NONE);
    private static final Quality BLOCKS = WHOLE.with("cloudResolution", 0.5);
    /** Root mean square, of the brightest pixel, as those of single pixels. */
    private static final double MEAN_ERROR = 0.01;
    /** The rim of a cloud is softer. */
    private static final double AT_RIM = 0.1;
    /** The edge of a surface is not. */
    private static final double AT_EDGE = 0.02;

    private static final int WIDTH = 192;

    private static final Vec3 SUN = new Vec3(0.4, 0.6, 0.7);
    private static final Vec3 EYE = new Vec3(0, 2, 0);

    private final Offscreen offscreen = new Offscreen(WIDTH, 128);

    @AfterAll
    void close() {
        offscreen.close();
    }

    /** Returns a level of a near cloud, one behind it and one behind every surface. */
    private static TestLevel clouds() {
        return new TestLevel()
                .sun(SUN, 3)
                .sky(new Sky.Constant(new Vec3(0.1, 0.2, 0.4)))
                .material("m", new Vec3(0.5, 0.4, 0.3))
                .cloud(new Vec3(0, 0, -60), new Vec3(70, 50, 60), 0.02, 1, 0.8)
                .cloud(new Vec3(0, 0, -200), new Vec3(150, 90, 100), 0.01, 0.9, 0.5)
                .cloud(new Vec3(0, 0, -900), new Vec3(9000, 6000, 200), 0.05, 1, 0);
    }

    private void assertSame(Level level, View view, double most) {
        float[] whole = radiance(level, view, WHOLE);
        float[] blocks = radiance(level, view, BLOCKS);
        float brightest = 0;
        for (float value : whole) {
            brightest = Math.max(brightest, value);
        }
        double squares = 0;
        for (int i = 0; i < whole.length; i++) {
            double error = (blocks[i] - whole[i]) / brightest;
            assertEquals(0, error, most, "pixel " + i / 3 % WIDTH + ", " + i / 3 / WIDTH);
            squares += error * error;
        }
        assertEquals(0, Math.sqrt(squares / whole.length), MEAN_ERROR);
        double[] reds = IntStream.range(0, whole.length / 3)
                .mapToDouble(i -> whole[3 * i])
                .distinct()
                .toArray();
        assertTrue(reds.length > 100, "the clouds are seen: " + reds.length);
    }

    private float[] radiance(Level level, View view, Quality quality) {
        return offscreen
                .radiance(level, TestAssets.NONE, List.of(view), quality)
                .get(0);
    }

    /** A wall in the near cloud, between the two, in the other one, and between that and the last. */
    @ParameterizedTest
    @ValueSource(doubles = {-55, -120, -210, -400})
    void aWallAmongClouds(double z) {
        Level level =
                clouds().box("m", new Vec3(0, 0, z), new Vec3(3000, 2000, 1)).level();
        assertSame(level, offscreen.view(EYE, new Vec3(1, 1, -10)), AT_RIM);
    }

    /** Thin posts at two distances in front of a wall and of a floor that is seen at a grazing angle, all in a layer. */
    @Test
    void edges() {
        var level = new TestLevel()
                .sun(SUN, 3)
                .material("m", new Vec3(0.5, 0.4, 0.3))
                .layer(-60, 120, 0.02, 1, 0.8)
                .box("m", new Vec3(0, 0, -210), new Vec3(900, 600, 1))
                .box("m", new Vec3(0, -6, -100), new Vec3(300, 1, 200));
        for (int i = -4; i <= 4; i++) {
            level.box("m", new Vec3(2 * i, 0, -32), new Vec3(0.5 + 0.1 * i, 20, 0.5));
            level.box("m", new Vec3(3.7 * i, 4, -55), new Vec3(1 + 0.2 * i, 2, 0.5));
        }
        assertSame(level.level(), offscreen.view(EYE, new Vec3(0.5, 1.5, -10)), AT_EDGE);
    }

    @Test
    void aWallBehindAnOpening() {
        Level level = clouds().box("m", new Vec3(0, 0, -210), new Vec3(900, 600, 1))
                .box("m", new Vec3(0, 2, 301), new Vec3(30, 30, 1))
                .box("m", new Vec3(0, 2, -0.5), new Vec3(3, 3, 0.4))
                .portal("a", "b", new Vec3(0, 2, 300.5), new Vec3(0, 0, -1), 4, 4)
                .portal("b", "a", new Vec3(0, 2, -0.7), new Vec3(0, 0, -1), 2.8, 2.8)
                .level();
        assertSame(level, offscreen.view(new Vec3(0, 2, 297), new Vec3(0.3, 2, 310)), AT_RIM);
    }
}
