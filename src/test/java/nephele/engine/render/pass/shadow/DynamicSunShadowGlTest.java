package nephele.engine.render.pass.shadow;

import static org.junit.jupiter.api.Assertions.assertEquals;
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
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;

/** Dynamic objects far apart cast shadows of the sun. */
class DynamicSunShadowGlTest {
    private static final int WIDTH = 160;
    private static final int HEIGHT = 90;

    private static TestLevel floor() {
        return new TestLevel()
                .castingSun(new Vec3(0.6, 1, 0), Math.PI)
                .box(null, new Vec3(0, -0.5, 0), new Vec3(500, 1, 30));
    }

    private static Body cube(String id, double x) {
        return new Body.Box(id, new Vec3(x, 1.5, 0), TestLevel.grey(1), 1, null, 0, 0);
    }

    private static View above(double x) {
        return View.lookAt(
                new Vec3(x, 6, 0),
                new Vec3(x, 0, 0),
                new Vec3(0, 0, -1),
                new Projection(Math.PI / 3, WIDTH / (double) HEIGHT, 0.1, 100));
    }

    private static int dark(Renderer renderer) {
        int dark = 0;
        float[] rgb = renderer.readRadiance();
        for (int i = 0; i < rgb.length; i += 3) {
            dark += rgb[i] < 0.05 ? 1 : 0;
        }
        return dark;
    }

    /** @param views one frame each @return the number of pixels in shadow in the last one */
    private static int dark(Offscreen offscreen, Level level, View... views) {
        RenderSettings settings = RenderSettings.of(Output.HDR).with(Decoration.OFF);
        try (Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings)) {
            for (View view : views) {
                renderer.draw(view, offscreen.picture);
            }
            return dark(renderer);
        }
    }

    /** Objects near the eye have shadows, however far the eye moves. */
    @Test
    void shadowsAreThereWhereTheEyeGoes() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            int alone = dark(offscreen, floor().body(cube("b", 200)).level(), above(200));
            assertTrue(alone > 100, alone + " pixels");
            Level both = floor().body(cube("a", 0)).body(cube("b", 200)).level();
            assertEquals(alone, dark(offscreen, both, above(0), above(200)), 0.05 * alone);
        }
    }

    /** Objects seen through a portal 40 m away have shadows, while others are near the eye. */
    @Test
    void shadowsAreThereBehindAPortal() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            TestLevel portals = floor().portal("p", "q", new Vec3(0, 4, 0), new Vec3(0, 1, 0), 8, 5)
                    .portal("q", "p", new Vec3(40, 4, 0), new Vec3(0, -1, 0), 8, 5);
            int alone = dark(offscreen, portals.body(cube("b", 40)).level(), above(0));
            assertTrue(alone > 100, alone + " pixels");
            assertEquals(alone, dark(offscreen, portals.body(cube("a", 0)).level(), above(0)), 0.2 * alone);
        }
    }
}
