package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.pass.dynamic.DynamicPass;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.View;
import nephele.engine.scene.dynamic.CharacterPresence;
import org.junit.jupiter.api.Test;

/**
 * A held body is transparent in the player's own first-person view and solid in every other image. Black in front of
 * white.
 */
class HeldGlTest {
    private static final int WIDTH = 160;
    private static final int HEIGHT = 90;
    private static final int BLACK = 0;
    /** The code of a white wall behind the middle of a black face. */
    private static final int THROUGH = (int) Math.round(255 * (1 - DynamicPass.HELD_FACE_OPACITY));

    private static final Vec3 BEFORE_THE_EYE = new Vec3(0, 0, -1);
    private static final Vec3 ELSEWHERE = new Vec3(0, 0, -3);

    private static TestLevel blackBeforeWhite(Body body) {
        return new TestLevel()
                .ambient(1)
                .material("black", Vec3.ZERO)
                .material("white", TestLevel.grey(1))
                .box("white", new Vec3(0, 0, -9.5), new Vec3(40, 40, 1))
                .box("white", new Vec3(0, 0, 9.5), new Vec3(40, 40, 1))
                .body(body);
    }

    private static TestLevel cubeBeforeWhite(double z) {
        return blackBeforeWhite(new Body.Box("held", new Vec3(0, 0, z), TestLevel.grey(0.6), 10, "black", 0.6, 0));
    }

    private static int[] draw(Offscreen offscreen, Level level, Quality quality, Vec3 heldFromEye) {
        return draw(offscreen, level, quality, heldFromEye, 1);
    }

    private static int[] draw(Offscreen offscreen, Level level, Quality quality, Vec3 heldFromEye, double clarity) {
        RenderSettings settings =
                RenderSettings.of(Output.PLAIN, quality).with(Decoration.OFF).with(CharacterPresence.POSSIBLE);
        try (Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings)) {
            FrameState frameState = FrameState.atStart(level);
            if (heldFromEye != null) {
                frameState.held(0, heldFromEye, clarity);
            }
            View view = offscreen.view(Vec3.ZERO, new Vec3(0, 0, -1));
            renderer.draw(view, frameState, offscreen.picture);
            offscreen.gl.requireNoError("held");
            return offscreen.pixels();
        }
    }

    private static int middle(int[] pixels) {
        return pixels[HEIGHT / 2 * WIDTH + WIDTH / 2];
    }

    private static int count(int[] pixels, int rgb) {
        int found = 0;
        for (int pixel : pixels) {
            found += pixel == rgb ? 1 : 0;
        }
        return found;
    }

    private static void assertSeenThrough(int[] pixels) {
        assertEquals(THROUGH, Offscreen.red(middle(pixels)), 1);
        assertEquals(0, count(pixels, BLACK), "what hides all that is behind");
    }

    @Test
    void whatIsBehindShowsThrough() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            Level cube = cubeBeforeWhite(-1).level();
            int[] held = draw(offscreen, cube, Quality.HIGH, BEFORE_THE_EYE);
            assertSeenThrough(held);
            int[] solid = draw(offscreen, cube, Quality.HIGH, null);
            assertEquals(BLACK, middle(solid));
            int covered = 0;
            int edges = 0;
            for (int i = 0; i < held.length; i++) {
                covered += solid[i] == BLACK ? 1 : 0;
                edges += Offscreen.red(held[i]) < THROUGH / 2 ? 1 : 0;
                assertEquals(solid[i] == 0xffffff, held[i] == 0xffffff, "the silhouette");
            }
            assertTrue(edges > covered / 50 && edges < covered / 4, edges + " dark of " + covered);
        }
    }

    /** The body changes gradually from solid to transparent by the share of the picture that it hides. */
    @Test
    void itClearsGradually() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            Level cube = cubeBeforeWhite(-1).level();
            for (double clarity : new double[] {0.25, 0.75}) {
                int[] held = draw(offscreen, cube, Quality.HIGH, BEFORE_THE_EYE, clarity);
                assertEquals(clarity * THROUGH, Offscreen.red(middle(held)), 1);
            }
        }
    }

    @Test
    void aRoundBodyHidesMoreTowardsItsOutline() {
        Body ball = new Body.Sphere("held", BEFORE_THE_EYE, 0.3, 10, "black", 0.6, 0);
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            int[] held = draw(offscreen, blackBeforeWhite(ball).level(), Quality.HIGH, BEFORE_THE_EYE);
            assertSeenThrough(held);
            int darkest = 255;
            for (int pixel : held) {
                darkest = Math.min(darkest, Offscreen.red(pixel));
            }
            assertTrue(darkest < THROUGH / 2, "outline " + darkest);
        }
    }

    /** In third person, and in images of it elsewhere, the body is solid. */
    @Test
    void fromElsewhereItIsSolid() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            Level cube = cubeBeforeWhite(-1).level();
            int[] solid = draw(offscreen, cube, Quality.HIGH, null);
            assertArrayEquals(solid, draw(offscreen, cube, Quality.HIGH, ELSEWHERE));
        }
    }

    /**
     * A pair of portals changes nothing: held in front of it, in it and beyond it, the body looks as without portals.
     */
    @Test
    void throughAPortalItIsSeenThroughAlike() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            for (double plane : new double[] {-0.5, -1, -1.5}) {
                assertSeenThrough(draw(offscreen, heldAcross(plane), Quality.HIGH, BEFORE_THE_EYE));
            }
            for (PortalTechnique technique : PortalTechnique.values()) {
                Quality quality = Quality.HIGH.with("portalTechnique", technique);
                assertSeenThrough(draw(offscreen, heldAcross(-0.8), quality, BEFORE_THE_EYE));
            }
        }
    }

    private static Level heldAcross(double plane) {
        return cubeBeforeWhite(-1)
                .portal("a", "b", new Vec3(0, 0, plane), new Vec3(0, 0, 1), 3, 3)
                .portal("b", "a", new Vec3(0, 0, plane), new Vec3(0, 0, -1), 3, 3)
                .level();
    }

    /** A portal beside the held cube shows it from behind, solid. */
    @Test
    void aPortalThatLooksBackShowsItSolid() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            Level level = cubeBeforeWhite(-1)
                    .portal("a", "b", new Vec3(-1.5, 0, -2), new Vec3(0, 0, 1), 1, 2)
                    .portal("b", "a", new Vec3(-2.25, 0, -4), new Vec3(0, 0, 1), 1, 2)
                    .level();
            int[] nobodys = draw(offscreen, level, Quality.HIGH, null);
            int[] held = draw(offscreen, level, Quality.HIGH, BEFORE_THE_EYE);
            assertEquals(THROUGH, Offscreen.red(middle(held)), 1);
            int black = 0;
            for (int i = 0; i < held.length; i++) {
                if (i % WIDTH < WIDTH / 2 - 21) {
                    assertEquals(nobodys[i], held[i]);
                    black += held[i] == BLACK ? 1 : 0;
                }
            }
            assertTrue(black > 20, black + " pixels of the cube's image");
        }
    }
}
