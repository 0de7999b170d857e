package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;

import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;

/** Nearer surfaces hide farther ones. */
class OcclusionGlTest {
    private static final Vec3 RED = new Vec3(1, 0, 0);
    private static final Vec3 GREEN = new Vec3(0, 1, 0);
    private static final Vec3 MAGENTA = new Vec3(1, 0, 1);

    @Test
    void theNearerBoxHidesTheFartherOneFromBothSides() {
        Level level = new TestLevel()
                .ambient(1)
                .material("red", RED)
                .material("green", GREEN)
                .box("red", new Vec3(0, 0, -5), new Vec3(2, 2, 2))
                .box("green", new Vec3(0, 0, 5), new Vec3(2, 2, 2))
                .level();
        try (Offscreen offscreen = new Offscreen(9, 9)) {
            View fromFront = offscreen.view(new Vec3(0.1, 0.2, -12), Vec3.ZERO);
            View fromBack = offscreen.view(new Vec3(0.1, 0.2, 12), Vec3.ZERO);
            assertEquals(0xff0000, offscreen.pixels(level, fromFront, Output.PLAIN)[40]);
            assertEquals(0x00ff00, offscreen.pixels(level, fromBack, Output.PLAIN)[40]);
        }
    }

    /** A wall at nine tenths of the far distance is in front of every kind of drawn sky, which is visible beside it. */
    @Test
    void theSkyIsBehindEverything() {
        Sky sky = new Sky.Gradient(MAGENTA, MAGENTA, MAGENTA);
        Level level = new TestLevel()
                .ambient(1)
                .sky(sky)
                .material("green", GREEN)
                .box("green", new Vec3(0, 0, -905), new Vec3(900, 900, 10))
                .level();
        try (Offscreen offscreen = new Offscreen(9, 9)) {
            int[] pixels = offscreen.pixels(level, offscreen.view(Vec3.ZERO, new Vec3(0, 0, -1)), Output.PLAIN);
            assertEquals(0x00ff00, pixels[40]);
            assertEquals(0xff00ff, pixels[0]);
        }
    }
}
