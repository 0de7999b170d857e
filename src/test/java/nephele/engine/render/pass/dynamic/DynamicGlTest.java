package nephele.engine.render.pass.dynamic;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.FrameState.Posture;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import nephele.engine.scene.dynamic.CharacterPresence;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** Bodies and the character are drawn on both sides of the portals that they reach through. */
class DynamicGlTest {
    private static final int WIDTH = 160;
    private static final int HEIGHT = 90;
    private static final int BACKGROUND = 0x000000;

    private static RenderSettings settings(Output output) {
        return RenderSettings.of(output).with(Decoration.OFF);
    }

    private static TestLevel white() {
        return new TestLevel().ambient(1).material("white", TestLevel.grey(1));
    }

    private static int[] draw(Offscreen offscreen, Level level, View view) {
        return offscreen.pixels(level, TestAssets.NONE, view, settings(Output.PLAIN));
    }

    private static int covered(int[] pixels) {
        int count = 0;
        for (int rgb : pixels) {
            count += rgb == BACKGROUND ? 0 : 1;
        }
        return count;
    }

    /** A box body looks like the solid of its shape, also after a move. */
    @Test
    void aBodyCoversWhatItsShapeCovers() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            View view = offscreen.view(new Vec3(1, 0.8, 2), new Vec3(0.1, 0, 0));
            Vec3 at = new Vec3(0.2, 0.1, -0.3);
            int[] solid =
                    draw(offscreen, white().box("white", at, TestLevel.grey(1)).level(), view);
            int[] body = draw(offscreen, white().cube("white", at, 1).level(), view);
            assertTrue(covered(solid) > 200);
            assertEquals(0, unlike(solid, body));
            Level elsewhere = white().cube("white", new Vec3(50, 0, 0), 1).level();
            try (Renderer renderer =
                    LevelRenderer.load(offscreen.gl, elsewhere, TestAssets.NONE, settings(Output.PLAIN))) {
                FrameState frameState = FrameState.atStart(elsewhere);
                frameState.body(0, at.toVector(), new Quaterniond().rotationY(Math.PI / 2));
                renderer.draw(view, frameState, offscreen.picture);
                assertEquals(covered(solid), covered(offscreen.pixels()), 2);
            }
        }
    }

    /**
     * Between a pair of portals that changes nothing, a body looks as without them, except for a pixel along the plane.
     */
    @Test
    void straddlingAPairThatChangesNothingChangesNothing() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            for (Vec3 eye : new Vec3[] {new Vec3(1.5, 1, 2), new Vec3(-2, 0.3, 0.6), new Vec3(0.3, 0.2, 1.6)}) {
                View view = offscreen.view(eye, new Vec3(0.1, 0, 0));
                for (double ahead : new double[] {0.02, 0.2, 0.45}) {
                    Vec3 at = new Vec3(0.1, 0.05, ahead);
                    TestLevel plain = white().sun(new Vec3(0.2, 1, 0.6), 1).cube("white", at, 1);
                    int[] expected = draw(offscreen, plain.level(), view);
                    TestLevel straddled = white().sun(new Vec3(0.2, 1, 0.6), 1).cube("white", at, 1);
                    Level level = straddled
                            .portal("a", "b", Vec3.ZERO, new Vec3(0, 0, 1), 3, 3)
                            .portal("b", "a", Vec3.ZERO, new Vec3(0, 0, -1), 3, 3)
                            .level();
                    int[] actual = draw(offscreen, level, view);
                    assertTrue(covered(expected) > 200, "the cube is seen: " + covered(expected));
                    assertEquals(0, unlike(expected, actual), "pixels from " + eye + " of a cube at " + ahead);
                }
            }
        }
    }

    /** Counts pixels whose colour occurs neither there nor at a neighbour in the other picture. */
    private static int unlike(int[] expected, int[] actual) {
        int count = 0;
        for (int y = 1; y + 1 < HEIGHT; y++) {
            for (int x = 1; x + 1 < WIDTH; x++) {
                boolean found = false;
                for (int i = 0; i < 9 && !found; i++) {
                    found = near(actual[y * WIDTH + x], expected[(y + i / 3 - 1) * WIDTH + x + i % 3 - 1]);
                }
                count += found ? 0 : 1;
            }
        }
        return count;
    }

    private static boolean near(int a, int b) {
        return Math.abs(Offscreen.red(a) - Offscreen.red(b)) <= 2
                && Math.abs(Offscreen.green(a) - Offscreen.green(b)) <= 2
                && Math.abs(Offscreen.blue(a) - Offscreen.blue(b)) <= 2;
    }

    /** The part in front of the exit and the rest in front of the entry add up to the whole. */
    @Test
    void theSilhouettesOfBothHalvesAddUp() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            for (double ahead : new double[] {0.05, 0.25, 0.4}) {
                TestLevel wall = white().cube("white", new Vec3(0, 0, ahead), 1);
                Level level = wall.portal("a", "b", Vec3.ZERO, new Vec3(0, 0, 1), 3, 3)
                        .portal("b", "a", new Vec3(40, 0, 0), new Vec3(1, 0, 0), 3, 3)
                        .level();
                // Along the planes, neither opening is visible.
                int host = covered(draw(offscreen, level, offscreen.view(new Vec3(2, 0, 0), new Vec3(0, 0, 0))));
                int image = covered(draw(offscreen, level, offscreen.view(new Vec3(40, 0, 2), new Vec3(40, 0, 0))));
                Level free = white().cube("white", new Vec3(0, 0, ahead), 1).level();
                int whole = covered(draw(offscreen, free, offscreen.view(new Vec3(2, 0, 0), new Vec3(0, 0, 0))));
                assertTrue(whole > 200, "the cube is seen: " + whole);
                assertEquals(whole, host + image, 0.04 * whole, "halves " + host + " and " + image);
                assertEquals((0.5 + ahead) * whole, host, 0.06 * whole, "cut at the plane");
            }
        }
    }

    /** Without culling every dynamic object is drawn, without narrowing also outside the opening. */
    @Test
    void settingsThatLeaveNothingOutLeaveNoBodyOut() {
        Level level = white().cube("white", new Vec3(0, 0, 9), 1)
                .cube("white", new Vec3(-9, 0, -3), 1)
                .portal("a", "b", new Vec3(0, 0, -2), new Vec3(0, 0, 1), 1, 1)
                .portal("b", "a", new Vec3(0, 0, -20), new Vec3(0, 0, 1), 1, 1)
                .level();
        RenderSettings usual = settings(Output.PLAIN);
        long least = triangles(level, usual);
        long whole = triangles(level, usual.with(RenderSettings.Narrowing.OFF));
        assertTrue(whole > least, whole + " and " + least);
        assertTrue(triangles(level, usual.with(RenderSettings.Culling.NONE)) > whole);
    }

    private static long triangles(Level level, RenderSettings settings) {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings)) {
            renderer.draw(offscreen.view(Vec3.ZERO, new Vec3(0, 0, -2)), offscreen.picture);
            return renderer.triangles();
        }
    }

    /** The head is hidden in the view from inside and visible in all others. */
    @Test
    void theHeadIsNotSeenFromWithin() {
        Level level =
                white().box("white", new Vec3(0, -0.5, 0), new Vec3(20, 1, 20)).level();
        Posture character = new Posture(new Vec3(0, 0.9, 0), new Vec3(0, 1, 0), 0, 0, 1.8, 0, 0, 0, 0, 0);
        RenderSettings played = settings(Output.PLAIN).with(CharacterPresence.POSSIBLE);
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, played)) {
            View within = offscreen.view(new Vec3(0, 1.65, 0), new Vec3(0, 1.65, -1));
            View before = offscreen.view(new Vec3(0, 1.65, -1), new Vec3(0, 1.65, 0));
            int[] alone = with(renderer, offscreen, within, level, null);
            assertArrayEquals(alone, with(renderer, offscreen, within, level, character));
            int[] empty = with(renderer, offscreen, before, level, null);
            int[] seen = with(renderer, offscreen, before, level, character);
            int middle = HEIGHT / 2 * WIDTH + WIDTH / 2;
            View backwards = offscreen.view(new Vec3(0, 1.65, 0.2), new Vec3(0, 1.65, -1));
            int[] bare = with(renderer, offscreen, backwards, level, null);
            assertEquals(
                    bare[middle], with(renderer, offscreen, backwards, level, character)[middle], "the helmet's back");
            assertNotEquals(empty[middle], seen[middle], "the visor");
        }
    }

    private static int[] with(Renderer renderer, Offscreen offscreen, View view, Level level, Posture character) {
        FrameState frameState = FrameState.atStart(level);
        frameState.character(character);
        renderer.draw(view, frameState, offscreen.picture);
        return offscreen.pixels();
    }

    /** Where a moved cube hides the sun and a light, the ground is dark, and nowhere else. */
    @Test
    void aMovedCubeCastsTheShadowOfItsShape() {
        Vec3 sun = new Vec3(0.5, 1, 0.3);
        Vector3d centre = new Vector3d(0.3, 1.2, -0.2);
        Level level = new TestLevel()
                .castingSun(sun, Math.PI)
                .box(null, new Vec3(0, -0.5, 0), new Vec3(30, 1, 30))
                .body(new Body.Box("b", new Vec3(5, 1, 5), TestLevel.grey(0.8), 1, null, 0, 0))
                .level();
        Quaterniond turn = new Quaterniond().rotationXYZ(0.4, 0.7, 0.2);
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings(Output.HDR))) {
            View view = View.lookAt(
                    new Vec3(0, 4, 0),
                    Vec3.ZERO,
                    new Vec3(0, 0, -1),
                    new Projection(Math.PI / 3, WIDTH / (double) HEIGHT, 0.1, 100));
            FrameState frameState = FrameState.atStart(level);
            renderer.draw(view, frameState, offscreen.picture);
            frameState.body(0, centre, turn);
            renderer.draw(view, frameState, offscreen.picture);
            float[] rgb = renderer.readRadiance();
            assertShadow(rgb, centre, turn, sun.toVector().normalize());
        }
    }

    private static void assertShadow(float[] rgb, Vector3d centre, Quaterniond turn, Vector3d sun) {
        double half = 4 * Math.tan(Math.PI / 6);
        int dark = 0;
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            double z = -half * (2 * (i / WIDTH + 0.5) / HEIGHT - 1);
            double x = half * WIDTH / HEIGHT * (2 * (i % WIDTH + 0.5) / WIDTH - 1);
            Vector3d eye = new Vector3d(0, 4, 0);
            Vector3d ground = new Vector3d(x, 0, z);
            if (hits(eye, new Vector3d(ground).sub(eye), centre, turn, 1.03)) {
                continue;
            }
            boolean surely = hits(ground, sun, centre, turn, 0.96);
            boolean perhaps = hits(ground, sun, centre, turn, 1.04);
            if (surely == perhaps) {
                dark += surely ? 1 : 0;
                assertEquals(surely ? 0 : 0.5 * sun.y, rgb[3 * i], 0.01, "ground at " + x + ", " + z);
            }
        }
        assertTrue(dark > 50, "the picture shows the shadow: " + dark);
    }

    /** Returns true if a half-line hits the cube, scaled. */
    private static boolean hits(Vector3d from, Vector3d way, Vector3d centre, Quaterniond turn, double scale) {
        Vector3d o = turn.transformInverse(new Vector3d(from).sub(centre));
        Vector3d d = turn.transformInverse(new Vector3d(way));
        double enter = 0;
        double leave = 1e9;
        for (int axis = 0; axis < 3; axis++) {
            double a = (-0.4 * scale - o.get(axis)) / d.get(axis);
            double b = (0.4 * scale - o.get(axis)) / d.get(axis);
            enter = Math.max(enter, Math.min(a, b));
            leave = Math.min(leave, Math.max(a, b));
        }
        return enter <= leave;
    }
}
