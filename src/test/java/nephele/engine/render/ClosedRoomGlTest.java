package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Random;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;

/** No background is visible where surfaces join; the room is closed and the sky magenta. */
class ClosedRoomGlTest {
    private static final int VIEWS = 500;
    private static final Vec3 MAGENTA = new Vec3(1, 0, 1);

    /** Returns walls whose edges end in the middle of each other's faces, at coordinates that floats round. */
    private static TestLevel room(double offset) {
        TestLevel level = new TestLevel().sky(new Sky.Constant(MAGENTA)).material("green", new Vec3(0, 0.5, 0));
        double[][] boxes = {
            {0, -0.15, 0, 9.3, 0.3, 7.1},
            {0, 3.25, 0, 9.3, 0.3, 7.1},
            {-4.6, 1.55, 0, 0.1, 3.1, 7.1},
            {4.6, 1.55, -1.7, 0.1, 3.1, 3.7},
            {4.6, 1.55, 1.85, 0.1, 3.1, 3.4},
            {-1.1, 1.55, -3.5, 6.9, 3.1, 0.1},
            {3.45, 0.7, -3.5, 2.2, 1.4, 0.1},
            {3.45, 2.25, -3.5, 2.2, 1.7, 0.1},
            {0, 1.55, 3.5, 9.1, 3.1, 0.1},
            {1.3, 0.45, 0.7, 0.9, 0.9, 0.9}
        };
        for (double[] b : boxes) {
            level.box("green", new Vec3(b[0] + offset, b[1], b[2] - offset), new Vec3(b[3], b[4], b[5]));
        }
        return level;
    }

    @Test
    void noSkyIsSeenInAClosedRoom() {
        assertNoSky(room(0.1).ambient(1).level(), 0.1);
    }

    /** No sky is visible far from the origin with faces divided for the light map. */
    @Test
    void noSkyIsSeenBetweenThePartsOfCutFaces() {
        assertNoSky(room(12345.7).skyLight().level(), 12345.7);
    }

    /** Returns true for places where no eye can be: faces of solids that touch are not drawn there. */
    private static boolean isInCrate(Vec3 eye, double offset) {
        double x = Math.abs(eye.x() - offset - 1.3);
        double z = Math.abs(eye.z() + offset - 0.7);
        return x <= 0.45 && z <= 0.45 && eye.y() <= 0.9;
    }

    private static void assertNoSky(Level level, double offset) {
        Random random = new Random(20);
        try (Offscreen offscreen = new Offscreen(64, 64);
                Renderer renderer =
                        LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, RenderSettings.of(Output.PLAIN))) {
            for (int i = 0; i < VIEWS; i++) {
                Vec3 eye = new Vec3(
                        offset + 8.6 * (random.nextDouble() - 0.5),
                        0.2 + 2.7 * random.nextDouble(),
                        -offset + 6.4 * (random.nextDouble() - 0.5));
                if (isInCrate(eye, offset)) {
                    continue;
                }
                Vec3 target = new Vec3(
                        eye.x() + random.nextGaussian(),
                        eye.y() + random.nextGaussian(),
                        eye.z() + random.nextGaussian());
                Projection projection = new Projection(Math.toRadians(100), 1, 0.001, 100);
                renderer.draw(View.lookAt(eye, target, new Vec3(0, 1, 0), projection), offscreen.picture);
                long magenta = Arrays.stream(offscreen.pixels())
                        .filter(p -> Offscreen.red(p) > 100)
                        .count();
                assertEquals(0, magenta, "from " + eye + " to " + target);
            }
        }
    }
}
