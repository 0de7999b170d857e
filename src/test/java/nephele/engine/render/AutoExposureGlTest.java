package nephele.engine.render;

import static nephele.engine.render.MeteredFrames.EYE;
import static nephele.engine.render.MeteredFrames.HDR;
import static nephele.engine.render.MeteredFrames.HEIGHT;
import static nephele.engine.render.MeteredFrames.TO_WALL;
import static nephele.engine.render.MeteredFrames.WIDTH;
import static nephele.engine.render.MeteredFrames.draw;
import static nephele.engine.render.MeteredFrames.load;
import static nephele.engine.render.MeteredFrames.stops;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.ToneCurve;
import nephele.engine.level.appearance.AutoExposure;
import nephele.engine.level.appearance.LuminanceHistogram;
import nephele.engine.math.Vec3;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Pictures of a level with exposure auto: metered with all that they show, adapting in simulated time, safe at cuts. */
class AutoExposureGlTest {
    private static final Vec3 TO_SKY = new Vec3(0, 0, 1);

    /** Returns a wall in the dark before the eye, and a bright sky behind it. */
    private static TestLevel darkAndBright() {
        return new TestLevel()
                .toneMapping(ToneCurve.FILMIC, 0)
                .autoExposure()
                .ambient(0.02)
                .sky(new Sky.Gradient(new Vec3(1, 2, 4), new Vec3(3, 3, 3), new Vec3(1, 0.8, 0.6)))
                .material("wall", new Vec3(0.5, 0.4, 0.3))
                .box("wall", new Vec3(0, 0, -6), new Vec3(60, 60, 2));
    }

    /** Returns a dark room with a portal in the wall before the eye, which shows the sky behind the room. */
    private static TestLevel withPortal() {
        return darkAndBright()
                .portal("a", "b", new Vec3(0, 0, -5), new Vec3(0, 0, 1), 8, 6)
                .portal("b", "a", new Vec3(0, 0, 20), new Vec3(0, 0, 1), 8, 6)
                .box("wall", new Vec3(0, 0, 19), new Vec3(10, 8, 2));
    }

    private static int greatestDifference(int[] a, int[] b) {
        int greatest = 0;
        for (int i = 0; i < a.length; i++) {
            for (int shift = 0; shift < 24; shift += 8) {
                greatest = Math.max(greatest, Math.abs((a[i] >> shift & 255) - (b[i] >> shift & 255)));
            }
        }
        return greatest;
    }

    /** Views through portals are part of the picture, however they are drawn. */
    @ParameterizedTest
    @CsvSource({"STENCIL, 1", "TEXTURE, 1", "COPY, 1", "STENCIL, 4"})
    void thePictureIsMeteredAsByTheTwin(PortalTechnique technique, int samples) {
        Quality quality = Quality.HIGH.with("portalTechnique", technique).with("samples", samples);
        RenderSettings settings = RenderSettings.of(Output.HDR, quality).with(Decoration.OFF);
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer renderer =
                        LevelRenderer.load(offscreen.gl, withPortal().level(), TestAssets.NONE, settings)) {
            double metered = draw(offscreen, renderer, TO_WALL, 0);
            float[] rgb = renderer.readRadiance();
            double twin = AutoExposure.stops(LuminanceHistogram.of(rgb, WIDTH), AutoExposure.MOST_STOPS);
            assertEquals(twin, metered, 2e-3);
            Level without = darkAndBright().level();
            assertTrue(
                    metered < stops(offscreen, without, settings, offscreen.view(EYE, TO_WALL)) - 1, "the sky counts");
        }
    }

    /** Right in front of a portal an eye sees what it would see behind the partner. */
    @Test
    void aPortalThatFillsThePictureIsMeteredAsThePlaceBehindIt() {
        RenderSettings settings = HDR.with(Decoration.OFF);
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            View through = offscreen.view(new Vec3(0, 0, -4.5), new Vec3(0, 0, -9));
            // The portals face the same way, so what is in front of one is behind the other, turned around.
            View behind = offscreen.view(new Vec3(0, 0, 19.5), new Vec3(0, 0, 30));
            Level open = darkAndBright().level();
            assertEquals(
                    stops(offscreen, open, settings, behind),
                    stops(offscreen, withPortal().level(), settings, through),
                    2e-3);
        }
    }

    @Test
    void theMeteredStopsLookAsTheSameStopsWrittenInTheLevel() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            for (Vec3 towards : List.of(TO_WALL, TO_SKY, new Vec3(1, 0, 0))) {
                Level auto = darkAndBright().level();
                try (Renderer renderer = load(offscreen, auto)) {
                    double metered = draw(offscreen, renderer, towards, 0);
                    int[] shown = offscreen.pixels();
                    Level fixed = auto.with(auto.environment().with(Exposure.ofStops(metered)), auto.lights());
                    int[] expected = offscreen.pixels(fixed, TestAssets.NONE, offscreen.view(EYE, towards), HDR);
                    assertTrue(greatestDifference(expected, shown) <= 1, "towards " + towards);
                }
            }
        }
    }

    /** Frame 0 after a cut is a cold start, to the bit; and it is converged: no later frame changes it. */
    @Test
    void afterACutThePictureIsThatOfAColdStart() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer warm = load(offscreen, withPortal().level());
                Renderer cold = load(offscreen, withPortal().level())) {
            draw(offscreen, cold, TO_WALL, 5);
            int[] expected = offscreen.pixels();
            draw(offscreen, warm, TO_SKY, 1);
            draw(offscreen, warm, TO_SKY, 2);
            warm.forget();
            double stops = draw(offscreen, warm, TO_WALL, 5);
            assertArrayEquals(expected, offscreen.pixels());
            assertEquals(stops, draw(offscreen, warm, TO_WALL, 60), 1e-4);
        }
    }

    @Test
    void turningToTheSkyAdaptsInSimulatedTime() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer renderer = load(offscreen, darkAndBright().level())) {
            double dark = draw(offscreen, renderer, TO_WALL, 1);
            assertEquals(dark, draw(offscreen, renderer, TO_SKY, 1), "no time has passed");
            double target = stops(offscreen, darkAndBright().level(), HDR, offscreen.view(EYE, TO_SKY));
            assertTrue(target < dark - 4, dark + " to " + target);
            double soon = draw(offscreen, renderer, TO_SKY, 1.25);
            assertEquals(AutoExposure.adapted(dark, target, 0.25), soon, 1e-3);
            assertEquals(target, draw(offscreen, renderer, TO_SKY, 100), 1e-3);
            assertTrue(draw(offscreen, renderer, TO_WALL, 100.25) < (dark + target) / 2, "slower to the dark");
        }
    }

    /** Time goes back where a level is restarted; another size is another window. */
    @Test
    void aRestartAndAResizeAreCuts() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer renderer = load(offscreen, darkAndBright().level());
                RenderTarget larger = RenderTarget.picture(offscreen.gl, "larger", PixelFormat.RGBA8, 200, 100)) {
            double cold = draw(offscreen, renderer, TO_WALL, 9);
            draw(offscreen, renderer, TO_SKY, 1000);
            assertEquals(cold, draw(offscreen, renderer, TO_WALL, 0), "restarted");
            View sky = offscreen.view(EYE, TO_SKY);
            renderer.draw(sky, larger);
            double resized = renderer.readMeteredStops().orElseThrow();
            renderer.forget();
            renderer.draw(sky, larger);
            assertEquals(renderer.readMeteredStops().orElseThrow(), resized, "resized");
            assertTrue(resized < cold - 4);
        }
    }

    /** An edit, a new bake and another quality replace the renderer; the eye goes on adapting. */
    @Test
    void theNextRendererContinuesTheAdaption() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            Renderer renderer = load(offscreen, darkAndBright().level());
            double dark = draw(offscreen, renderer, TO_WALL, 1);
            Level more = darkAndBright()
                    .box("wall", new Vec3(9, 9, 9), new Vec3(1, 1, 1))
                    .level();
            renderer = LevelRenderer.edited(renderer, Scene.of(more, TestAssets.NONE));
            assertEquals(dark, draw(offscreen, renderer, TO_SKY, 1));
            renderer.close();
        }
    }

    /** A frame's own exposure in stops holds at once, as the level's would. */
    @Test
    void stopsOfAFrameHoldAtOnce() {
        Level level = darkAndBright().level();
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer renderer = load(offscreen, level)) {
            draw(offscreen, renderer, TO_WALL, 0);
            FrameState state = FrameState.atStart(level);
            state.environment(level.environment().with(Exposure.ofStops(2.5)));
            renderer.draw(offscreen.view(EYE, TO_WALL), state, offscreen.picture);
            assertEquals(2.5, renderer.readMeteredStops().orElseThrow(), 1e-6);
        }
    }

    /** Only linear light can be metered: DIRECT shows the level at exposure 0, and nothing of it is built. */
    @Test
    void otherOutputsMeterNothing() {
        Level auto = darkAndBright().level();
        Level fixed = auto.with(auto.environment().with(Exposure.NEUTRAL), auto.lights());
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            View view = offscreen.view(EYE, TO_SKY);
            for (Output output : List.of(Output.DIRECT, Output.PLAIN)) {
                assertArrayEquals(offscreen.pixels(fixed, view, output), offscreen.pixels(auto, view, output));
            }
        }
    }
}
