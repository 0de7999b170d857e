package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;

/** What hides what. */
class OcclusionGlTest {
    private static final int SIZE = 96;
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

    /** A wall at nine tenths of the far distance stands before every kind of drawn sky, which is seen beside it. */
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

    /** C.2 row 20, with few cameras: the sky is magenta and no pixel of a closed room of mismatched blocks shows it. */
    @Test
    void aClosedRoomShowsNoSky() {
        assertEquals(0, magentaPixels(closedRoom(0)));
    }

    @Test
    void aCrackOfFiveCentimetresWouldBeSeen() {
        assertTrue(magentaPixels(closedRoom(0.05)) > 0);
    }

    private static long magentaPixels(Level room) {
        var random = new SplittableRandom(20);
        long magenta = 0;
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE);
                Renderer renderer =
                        Renderer.load(offscreen.gl, room, TestAssets.NONE, RenderSettings.of(Output.PLAIN))) {
            for (int camera = 0; camera < 60; camera++) {
                Vec3 eye =
                        new Vec3(random.nextDouble(0.1, 7.9), random.nextDouble(0.1, 2.9), random.nextDouble(0.1, 5.9));
                Vec3 target = new Vec3(random.nextDouble(8), random.nextDouble(3), random.nextDouble(6));
                renderer.draw(offscreen.view(eye, target), offscreen.picture);
                magenta += Arrays.stream(offscreen.pixels())
                        .filter(p -> p == 0xff00ff)
                        .count();
            }
        }
        return magenta;
    }

    /** Eight by three by six metres inside; the blocks of each wall are cut at other places than their neighbours'. */
    private static Level closedRoom(double crack) {
        TestLevel level = new TestLevel()
                .ambient(1)
                .sky(new Sky.Constant(MAGENTA))
                .material("green", GREEN)
                .box("green", new Vec3(4, -0.25, 3), new Vec3(9, 0.5, 7))
                .box("green", new Vec3(4, 3.25, 3), new Vec3(9, 0.5, 7));
        for (int side = 0; side < 2; side++) {
            for (int row = 0; row < 3; row++) {
                int columns = 3 + row + side;
                for (int i = 0; i < columns; i++) {
                    double x = 8.0 * (i + 0.5) / columns;
                    Vec3 alongX = new Vec3(8.0 / columns - crack, 1, 0.5);
                    level.box("green", new Vec3(x, row + 0.5, side == 0 ? -0.25 : 6.25), alongX);
                    double z = 7.0 * (i + 0.5) / columns - 0.5;
                    Vec3 alongZ = new Vec3(0.5, 1, 7.0 / columns - crack);
                    level.box("green", new Vec3(side == 0 ? -0.25 : 8.25, row + 0.5, z), alongZ);
                }
            }
        }
        return level.level();
    }
}
