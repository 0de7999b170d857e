package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;

/** A mirror shows what would be seen if the scene stood once more behind it, the other way round. */
class MirrorGlTest {
    private static final int WIDTH = 160;
    private static final int HEIGHT = 120;
    private static final double PLANE = -3;
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

    /** @param behind puts each box where the mirror shows it, too */
    private static Level boxes(Vec3 tint, boolean behind) {
        TestLevel level = room().material(new Material("silver", tint, null, null, null, null, Vec3.ZERO, 1, true));
        for (int i = 0; i < CENTRES.size(); i++) {
            Vec3 c = CENTRES.get(i);
            Vec3 size = new Vec3(0.5 + 0.3 * i, 0.9, 0.7 + 0.2 * i);
            level.box("m" + i, c, size);
            if (behind) {
                level.box("m" + i, new Vec3(c.x(), c.y(), 2 * PLANE - c.z()), size);
            }
        }
        if (!behind) {
            Map<BoxFace, Solid.Face> faces = Map.of(BoxFace.PLUS_Z, new Solid.Face("silver", null));
            level.solid(new Solid.Box(
                    "mirror",
                    "m0",
                    false,
                    TextureMapping.WORLD,
                    new Vec3(0, 0, PLANE - 0.5),
                    new Vec3(60, 60, 1),
                    faces));
        }
        return level.level();
    }

    private static RenderSettings by(PortalTechnique technique) {
        Quality quality =
                Quality.HIGH.withSamples(1).withPortalTechnique(technique).withPortalResolution(1);
        return RenderSettings.of(Output.PLAIN, quality);
    }

    private static int differing(int[] a, int[] b) {
        int count = 0;
        for (int i = 0; i < a.length; i++) {
            count += a[i] == b[i] ? 0 : 1;
        }
        return count;
    }

    /** By both techniques, from a metre, from a millimetre and nearly along the mirror; single pixels at edges may differ. */
    @Test
    void aMirrorIsTheSceneOnceMoreBehindIt() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            Level mirrored = boxes(new Vec3(1, 1, 1), false);
            Level twice = boxes(new Vec3(1, 1, 1), true);
            List<View> views = List.of(
                    offscreen.view(new Vec3(0.2, 0.3, 1.9), new Vec3(-0.1, 0, -3)),
                    offscreen.view(new Vec3(0.9, 0.3, PLANE + 1e-3), new Vec3(0.5, 0.2, -4)),
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

    /** What is reflected is multiplied by the base colour, what is seen beside the mirror is not. */
    @Test
    void theBaseColourTints() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            Level tinted = boxes(new Vec3(0.5, 0.2, 0.8), false);
            View view = offscreen.view(new Vec3(1, -0.6, 0), new Vec3(1, -0.6, -1.7));
            int[] seen = offscreen.pixels(tinted, TestAssets.NONE, view, by(PortalTechnique.STENCIL));
            assertEquals(0x00ff00, seen[HEIGHT / 2 * WIDTH + WIDTH / 2]);
            // The yellow box stands behind the eye.
            View back = offscreen.view(new Vec3(0.1, 0.1, 2), new Vec3(0.1, 0.1, -3));
            int[] reflected = offscreen.pixels(tinted, TestAssets.NONE, back, by(PortalTechnique.STENCIL));
            assertEquals(0x803300, reflected[HEIGHT / 2 * WIDTH + WIDTH / 2]);
        }
    }
}
