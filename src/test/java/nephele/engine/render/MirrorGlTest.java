package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.Solid;
import nephele.engine.level.TestLevel;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.View;
import nephele.engine.scene.dynamic.CharacterPresence;
import org.junit.jupiter.api.Test;

/** A mirror shows the scene reflected behind it. */
class MirrorGlTest {
    private static final int WIDTH = 160;
    private static final int HEIGHT = 120;
    private static final double PLANE_METRES = -3;
    private static final List<Vec3> COLOURS =
            List.of(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), new Vec3(1, 1, 0));
    private static final List<Vec3> CENTRES =
            List.of(new Vec3(-1.5, 0.4, -1), new Vec3(1, -0.6, -1.6), new Vec3(0.4, 1.2, 0.5), new Vec3(0, 0, 4));

    private static TestLevel room() {
        TestLevel level = new TestLevel().ambient(1);
        for (int i = 0; i < COLOURS.size(); i++) {
            level.material("m" + i, COLOURS.get(i));
        }
        return level;
    }

    /** @param behind true to put a copy of each box where the mirror shows it */
    private static Level boxes(Vec3 tint, boolean behind) {
        TestLevel level = room().material(new Material("silver", tint, null, null, null, null, Vec3.ZERO, 1, true));
        for (int i = 0; i < CENTRES.size(); i++) {
            Vec3 c = CENTRES.get(i);
            Vec3 size = new Vec3(0.5 + 0.3 * i, 0.9, 0.7 + 0.2 * i);
            level.box("m" + i, c, size);
            if (behind) {
                level.box("m" + i, new Vec3(c.x(), c.y(), 2 * PLANE_METRES - c.z()), size);
            }
        }
        if (!behind) {
            level.solid(mirror(new Vec3(60, 60, 1)));
        }
        return level.level();
    }

    private static RenderSettings by(PortalTechnique technique) {
        Quality quality = Quality.HIGH
                .with("samples", 1)
                .with("portalTechnique", technique)
                .with("portalResolution", 1);
        return RenderSettings.of(Output.PLAIN, quality);
    }

    private static int differing(int[] a, int[] b) {
        int count = 0;
        for (int i = 0; i < a.length; i++) {
            count += a[i] == b[i] ? 0 : 1;
        }
        return count;
    }

    /**
     * With both techniques, from a metre, from a millimetre and nearly along the mirror, the pictures agree except for
     * single pixels at edges.
     */
    @Test
    void aMirrorIsTheSceneOnceMoreBehindIt() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            Level mirrored = boxes(new Vec3(1, 1, 1), false);
            Level twice = boxes(new Vec3(1, 1, 1), true);
            List<View> views = List.of(
                    offscreen.view(new Vec3(0.2, 0.3, 1.9), new Vec3(-0.1, 0, -3)),
                    offscreen.view(new Vec3(0.9, 0.3, PLANE_METRES + 1e-3), new Vec3(0.5, 0.2, -4)),
                    offscreen.view(new Vec3(-4, 0.3, -1.5), new Vec3(4, 0.1, -3.2)));
            for (View view : views) {
                int[] expected = offscreen.pixels(twice, TestAssets.NONE, view, by(PortalTechnique.STENCIL));
                for (PortalTechnique technique : List.of(PortalTechnique.STENCIL, PortalTechnique.TEXTURE)) {
                    int[] seen = offscreen.pixels(mirrored, TestAssets.NONE, view, by(technique));
                    int wrong = differing(expected, seen);
                    assertTrue(wrong <= 12, technique + " from " + view.eye() + ": " + wrong + " pixels");
                }
            }
        }
    }

    /** The reflection is multiplied by the base colour, its surroundings are not. */
    @Test
    void theBaseColourTints() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            Level tinted = boxes(new Vec3(0.5, 0.2, 0.8), false);
            View view = offscreen.view(new Vec3(1, -0.6, 0), new Vec3(1, -0.6, -1.7));
            int[] seen = offscreen.pixels(tinted, TestAssets.NONE, view, by(PortalTechnique.STENCIL));
            assertEquals(0x00ff00, seen[HEIGHT / 2 * WIDTH + WIDTH / 2]);
            // The yellow box is behind the eye.
            View back = offscreen.view(new Vec3(0.1, 0.1, 2), new Vec3(0.1, 0.1, -3));
            int[] reflected = offscreen.pixels(tinted, TestAssets.NONE, back, by(PortalTechnique.STENCIL));
            assertEquals(0x803300, reflected[HEIGHT / 2 * WIDTH + WIDTH / 2]);
        }
    }

    /**
     * From the character's head, a mirror shows all of it, head included, as an eye beyond the mirror sees it, left and
     * right exchanged; from behind, the character itself is visible too.
     */
    @Test
    void oneSeesOneself() {
        Vec3 eye = new Vec3(0, 1.65, PLANE_METRES + 1);
        Vec3 image = new Vec3(0, 1.65, PLANE_METRES - 1);
        Level mirrored = room().material(
                        new Material("silver", new Vec3(1, 1, 1), null, null, null, null, Vec3.ZERO, 1, true))
                .solid(mirror(new Vec3(6, 6, 1)))
                .level();
        Level open = room().box("m0", new Vec3(0, -20, 0), new Vec3(1, 1, 1)).level();
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            int[] direct = withCharacter(offscreen, open, offscreen.view(image, eye));
            int[] expected = new int[direct.length];
            for (int i = 0; i < direct.length; i++) {
                expected[i] = direct[i / WIDTH * WIDTH + WIDTH - 1 - i % WIDTH];
            }
            int[] empty = new int[direct.length];
            int covered = differing(expected, empty);
            assertTrue(covered > 200, covered + " pixels of the character");
            assertTrue(expected[HEIGHT / 2 * WIDTH + WIDTH / 2] != 0, "the head");
            assertTrue(differing(expected, direct) > covered / 5, "the character is not symmetrical");
            int[] seen = withCharacter(offscreen, mirrored, offscreen.view(eye, image));
            int wrong = differing(expected, seen);
            assertTrue(wrong <= covered / 20, wrong + " of " + covered + " pixels");
            int[] fromBehind = withCharacter(
                    offscreen,
                    mirrored,
                    offscreen.view(new Vec3(1, 1.8, PLANE_METRES + 2.5), new Vec3(0, 1, PLANE_METRES)));
            assertTrue(differing(fromBehind, empty) > covered, "the character and its image");
        }
    }

    private static int[] withCharacter(Offscreen offscreen, Level level, View view) {
        RenderSettings settings = by(PortalTechnique.STENCIL).with(CharacterPresence.POSSIBLE);
        FrameState frameState = FrameState.atStart(level);
        frameState.character(new FrameState.Posture(
                new Vec3(0, 0.9, PLANE_METRES + 1), new Vec3(0, 1, 0), 0.4, 0, 1.8, 0.2, 0.7, 0, 0, 0));
        try (Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings)) {
            renderer.draw(view, frameState, offscreen.picture);
            offscreen.gl.requireNoError("character");
            return offscreen.pixels();
        }
    }

    /** Returns a wall whose face in {@link #PLANE_METRES} is a mirror. */
    private static Solid mirror(Vec3 size) {
        return new Solid.Box(
                "mirror",
                "m0",
                false,
                TextureMapping.WORLD,
                new Vec3(0, 0, PLANE_METRES - 0.5),
                size,
                Map.of(BoxFace.PLUS_Z, new Solid.Face("silver", null, null)));
    }
}
