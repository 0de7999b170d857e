package nephele.engine.render;

import static nephele.engine.render.MeteredFrames.EYE;
import static nephele.engine.render.MeteredFrames.HDR;
import static nephele.engine.render.MeteredFrames.HEIGHT;
import static nephele.engine.render.MeteredFrames.TO_WALL;
import static nephele.engine.render.MeteredFrames.WIDTH;
import static nephele.engine.render.MeteredFrames.draw;
import static nephele.engine.render.MeteredFrames.load;
import static nephele.engine.render.MeteredFrames.stops;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Exit;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.AutoExposure;
import nephele.engine.level.appearance.LuminanceHistogram;
import nephele.engine.math.Vec3;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Curtains, rims and membranes have values of the display, which would feed the exposure back to itself. */
class UnmeteredValuesGlTest {
    /** A curtain has the same display values at every exposure: it does not count, so the exposure does not follow it. */
    @Test
    void theCurtainOfAnExitDoesNotCount() {
        Exit exit = new Exit("exit", new Vec3(0, -1, -3), 1, 2.5);
        List<Double> shown = new ArrayList<>();
        for (double light : new double[] {2e-4, 0.3}) {
            TestLevel level = new TestLevel().autoExposure().sky(new Sky.Constant(TestLevel.grey(light)));
            try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                    Renderer veiled = load(offscreen, level.exit(exit).level());
                    Renderer renderer = LevelRenderer.load(
                            offscreen.gl, level.level(), TestAssets.NONE, HDR.with(Decoration.OFF))) {
                double metered = draw(offscreen, renderer, TO_WALL, 0);
                assertEquals(metered, draw(offscreen, veiled, TO_WALL, 0), 1e-3, "nor does its veil");
                float[] even = {(float) light, (float) light, (float) light};
                double expected = AutoExposure.stops(LuminanceHistogram.of(even, 1), AutoExposure.MOST_STOPS);
                assertEquals(expected, metered, 2e-3, "light " + light);
                double curtain = renderer.readRadiance()[3 * (HEIGHT / 2 * WIDTH + WIDTH / 2)] - light;
                shown.add(curtain * Math.pow(2, metered));
                for (int frame = 1; frame < 20; frame++) {
                    assertEquals(metered, draw(offscreen, renderer, TO_WALL, frame), 1e-4, "drift");
                }
            }
        }
        assertTrue(shown.get(0) > 0.05);
        assertEquals(shown.get(0), shown.get(1), 0.01, "the curtain's display value");
    }

    /** The membrane over a portal without a partner, its rim and its glow hide a part of an even wall. */
    @Test
    void rimsAndMembranesDoNotCount() {
        for (double light : new double[] {2e-4, 0.3}) {
            TestLevel wall = new TestLevel()
                    .autoExposure()
                    .ambient(light)
                    .material("wall", TestLevel.grey(0.5))
                    .box("wall", new Vec3(0, 0, -6), new Vec3(60, 60, 2));
            try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
                View view = offscreen.view(EYE, TO_WALL);
                double without = stops(offscreen, wall.level(), HDR, view);
                Level portal = wall.portal("a", null, new Vec3(0, 0, -5), new Vec3(0, 0, 1), 6, 6)
                        .level();
                assertEquals(without, stops(offscreen, portal, HDR, view), 1e-4, "light " + light);
            }
        }
    }

    /** The membrane behind a portal is hidden in the portal's own picture too. */
    @ParameterizedTest
    @EnumSource(PortalTechnique.class)
    void membranesBehindPortalsDoNotCount(PortalTechnique technique) {
        double light = 2e-4;
        Level level = new TestLevel()
                .autoExposure()
                .ambient(light)
                .sky(new Sky.Constant(TestLevel.grey(light)))
                .material("white", TestLevel.grey(1))
                .box("white", new Vec3(0, 0, -6), new Vec3(60, 60, 2))
                .portal("a", "b", new Vec3(0, 0, -5), new Vec3(0, 0, 1), 8, 6)
                .box("white", new Vec3(0, 0, 19), new Vec3(10, 8, 2))
                .portal("b", "a", new Vec3(0, 0, 20), new Vec3(0, 0, 1), 8, 6)
                .box("white", new Vec3(0, 0, 26), new Vec3(60, 60, 2))
                .portal("c", null, new Vec3(0, 0, 25), new Vec3(0, 0, -1), 12, 12)
                .level();
        RenderSettings settings = RenderSettings.of(Output.HDR, Quality.HIGH.with("portalTechnique", technique));
        float[] even = {(float) light, (float) light, (float) light};
        double expected = AutoExposure.stops(LuminanceHistogram.of(even, 1), AutoExposure.MOST_STOPS);
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            assertEquals(expected, stops(offscreen, level, settings, offscreen.view(EYE, TO_WALL)), 2e-3);
        }
    }
}
