package nephele.engine.render.cloud;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.measure.HdrFlip;
import nephele.engine.measure.LinearPicture;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.TwinProgram;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.CloudHistory;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Frames that share the rays through clouds show what a frame with all rays shows, and nothing from before a cut. */
@TestInstance(Lifecycle.PER_CLASS)
class CloudHistoryGlTest {
    private static final int WIDTH = 144;
    private static final int HEIGHT = 96;
    private static final Vec3 EYE = new Vec3(0, 2, 5);

    private final Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
    private final Scene clouds = Scene.of(clouds().level(), TestAssets.NONE);
    /** Draws with all rays, and keeps the clouds sampled for the renderers of the tests. */
    private final Renderer exact = load(clouds, CloudHistory.NONE);

    @AfterAll
    void close() {
        exact.close();
        offscreen.close();
    }

    /** A post behind the eye is as high as any wall of the tests: their levels have one region and so the same clouds. */
    private static TestLevel clouds() {
        return new TestLevel()
                .sun(new Vec3(0.4, 0.8, 0.3), 4)
                .ambient(0.4)
                .sky(new Sky.Gradient(new Vec3(0.1, 0.3, 0.8), new Vec3(0.5, 0.6, 0.8), new Vec3(0.2, 0.2, 0.2)))
                .material("wall", new Vec3(0.5, 0.4, 0.3))
                .box("wall", new Vec3(0, -0.5, 0), new Vec3(8, 1, 20))
                .box("wall", new Vec3(3.9, 6, 9.9), new Vec3(0.2, 12, 0.2))
                .cloud(new Vec3(0, 30, -90), new Vec3(60, 30, 40), 0.3, 1, 0.6)
                .cloud(new Vec3(0, 15, 60), new Vec3(40, 20, 30), 0.3, 1, 0.6)
                .cloud(new Vec3(40, 25, -50), new Vec3(30, 20, 30), 0.2, 1, 0.6)
                .cloud(new Vec3(-14, 10, -25), new Vec3(20, 8, 14), 0.4, 1, 0.6);
    }

    private static Level withPortals() {
        return clouds().box("wall", new Vec3(0, 2, -8), new Vec3(6, 4, 1))
                .box("wall", new Vec3(0, 2, 9), new Vec3(6, 4, 1))
                .portal("a", "b", new Vec3(0, 2, -7.5), new Vec3(0, 0, 1), 2, 3)
                .portal("b", "a", new Vec3(0, 2, 9.5), new Vec3(0, 0, 1), 2, 3)
                .level();
    }

    private Renderer load(Level level, CloudHistory history) {
        return load(Scene.of(level, TestAssets.NONE), history);
    }

    private Renderer load(Scene scene, CloudHistory history) {
        Quality quality = Quality.HIGH.with("cloudHistory", history);
        return LevelRenderer.load(offscreen.gl, scene, RenderSettings.of(Output.HDR, quality));
    }

    private float[] drawn(Renderer renderer, View view) {
        renderer.draw(view, offscreen.picture);
        offscreen.gl.requireNoError("frame");
        return renderer.readRadiance();
    }

    private float[] drawnWithAllRays(View view) {
        exact.forget();
        return drawn(exact, view);
    }

    /** Returns the views of an eye that turns by degrees and advances a little. */
    private List<View> flight(Vec3 from, double metresAFrame) {
        List<View> views = new ArrayList<>();
        for (int i = 0; i < 17; i++) {
            Vec3 eye = from.plus(new Vec3(0.2 * metresAFrame * i, 0, -metresAFrame * i));
            views.add(offscreen.view(eye, eye.plus(new Vec3(0.01 * i, 0.25, -1))));
        }
        return views;
    }

    @ParameterizedTest
    @EnumSource(CloudHistory.class)
    void aStillEyeSeesTheSameInEveryFrame(CloudHistory history) {
        try (Renderer renderer = load(clouds, history)) {
            View view = offscreen.view(EYE, new Vec3(0, 8, -20));
            float[] first = drawn(renderer, view);
            for (int frame = 1; frame <= 17; frame++) {
                assertArrayEquals(first, drawn(renderer, view), "frame " + frame);
            }
        }
    }

    @Test
    void framesAfterACutAreThoseOfAColdStart() {
        try (Renderer cold = load(clouds, CloudHistory.FOUR_FRAMES);
                Renderer warm = load(clouds, CloudHistory.FOUR_FRAMES)) {
            for (int i = 0; i < 6; i++) {
                drawn(warm, offscreen.view(new Vec3(9, 3, i), new Vec3(-20, 20, -60)));
            }
            warm.forget();
            boolean differs = false;
            List<View> flight = flight(EYE, 0.3);
            for (View view : flight) {
                float[] frame = drawn(cold, view);
                assertArrayEquals(frame, drawn(warm, view));
                differs |= !Arrays.equals(frame, drawnWithAllRays(view));
            }
            assertTrue(differs, "frames share their rays");
        }
    }

    /** With a surface as far as clouds, depth is read from a copy of the view; otherwise the depth test decides. */
    @Test
    void aSurfaceFarBehindTheEyeChangesNothing() {
        TestLevel walled = clouds().box("wall", new Vec3(-2, 6, -8), new Vec3(4, 12, 1));
        Level near = walled.level();
        Level far = walled.box("wall", new Vec3(0, 0, 400), new Vec3(4, 4, 4)).level();
        try (Renderer tested = load(near, CloudHistory.FOUR_FRAMES);
                Renderer read = load(far, CloudHistory.FOUR_FRAMES)) {
            for (View view : flight(EYE, 0.3).subList(0, 3)) {
                assertArrayEquals(drawn(read, view), drawn(tested, view));
            }
        }
    }

    @Test
    void aPassageThroughAPortalIsACut() {
        Level level = withPortals();
        try (Renderer cold = load(level, CloudHistory.FOUR_FRAMES);
                Renderer warm = load(level, CloudHistory.FOUR_FRAMES)) {
            for (double z = -6.5; z > -7.5; z -= 0.25) {
                Vec3 eye = new Vec3(0.5, 2, z);
                drawn(warm, offscreen.view(eye, eye.plus(new Vec3(0, 0.1, -1))));
            }
            // Both portals face +z: what enters one towards -z leaves the other towards +z.
            for (double z = 9.75; z < 11; z += 0.25) {
                Vec3 eye = new Vec3(-0.5, 2, z);
                View view = offscreen.view(eye, eye.plus(new Vec3(0.1 * (z - 9.5), 0.3, 1)));
                assertArrayEquals(drawn(cold, view), drawn(warm, view), "z " + z);
            }
        }
    }

    /** The eye advances 12 m/s at 60 frames a second, past one cloud and through its edge. */
    @Test
    void aFlightLooksAsWithAllRays() {
        List<View> flight = flight(new Vec3(-10, 10, -14), 0.2);
        Film truth = Film.of(flight, view -> picture(drawnWithAllRays(view)));
        requireLooksAs(truth, drawn(flight, CloudHistory.FOUR_FRAMES), 0.012, 0.01);
        requireLooksAs(truth, drawn(flight, CloudHistory.SIXTEEN_FRAMES), 0.025, 0.02);
    }

    /** A frame after an eye has left a cloud, rays meet another one far behind it. */
    @Test
    void nothingIsLeftOfACloudThatTheEyeHasLeft() {
        Level level = new TestLevel()
                .sun(new Vec3(0.4, 0.8, 0.3), 4)
                .sky(new Sky.Gradient(new Vec3(0.1, 0.3, 0.8), new Vec3(0.5, 0.6, 0.8), new Vec3(0.2, 0.2, 0.2)))
                .cloud(new Vec3(0, 10, 0), new Vec3(20, 12, 20), 0.4, 1, 0.6)
                .cloud(new Vec3(0, 600, -3000), new Vec3(6000, 1500, 400), 5e-4, 1, 0.6)
                .level();
        Scene scene = Scene.of(level, TestAssets.NONE);
        try (Renderer shared = load(scene, CloudHistory.SIXTEEN_FRAMES);
                Renderer whole = load(scene, CloudHistory.NONE)) {
            double error = 0;
            for (double z : new double[] {-6, -8, -11}) {
                View view = offscreen.view(new Vec3(0, 10, z), new Vec3(0, 10.2, z - 1));
                error = HdrFlip.of(picture(drawn(whole, view)), picture(drawn(shared, view)))
                        .mean();
            }
            assertTrue(error < 0.01, "FLIP " + error);
        }
    }

    /** The frames of a flight. @param steps how much each but the first differs from the one before */
    private record Film(List<LinearPicture> frames, List<Double> steps) {
        static Film of(List<View> flight, Function<View, LinearPicture> draw) {
            List<LinearPicture> frames = flight.stream().map(draw).toList();
            List<Double> steps = new ArrayList<>();
            for (int i = 1; i < frames.size(); i++) {
                steps.add(HdrFlip.of(frames.get(i - 1), frames.get(i)).mean());
            }
            return new Film(frames, steps);
        }
    }

    private Film drawn(List<View> flight, CloudHistory history) {
        try (Renderer shared = load(clouds, history)) {
            return Film.of(flight, view -> picture(drawn(shared, view)));
        }
    }

    private static void requireLooksAs(Film truth, Film seen, double most, double mostOfStep) {
        for (int i = 0; i < seen.frames.size(); i++) {
            double error = HdrFlip.of(truth.frames.get(i), seen.frames.get(i)).mean();
            assertTrue(error < most, "frame " + i + ": FLIP " + error + " of " + most);
        }
        for (int i = 0; i < seen.steps.size(); i++) {
            double step = seen.steps.get(i);
            double least = truth.steps.get(i);
            assertTrue(step < least + mostOfStep, "frame " + (i + 1) + ": step " + step + " for " + least);
        }
    }

    private static LinearPicture picture(float[] rgb) {
        return new LinearPicture(WIDTH, HEIGHT, rgb);
    }

    @Test
    void aSmallerPictureBeginsAnew() {
        try (Renderer renderer = load(clouds, CloudHistory.FOUR_FRAMES);
                Renderer cold = load(clouds, CloudHistory.FOUR_FRAMES);
                RenderTarget small = RenderTarget.picture(offscreen.gl, "small", PixelFormat.RGBA8, 33, 21)) {
            drawn(renderer, offscreen.view(EYE, new Vec3(0, 8, -20)));
            View view = offscreen.view(new Vec3(3, 2, 5), new Vec3(0, 9, -20));
            renderer.draw(view, small);
            cold.draw(view, small);
            assertArrayEquals(cold.readRadiance(), renderer.readRadiance());
        }
    }

    @Test
    void whatIsNoNumberIsReplaced() {
        float[] tried = {1, Float.NaN, -Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY, 65504, 3e38f, -2, 0
        };
        float[] inputs = new float[4 * tried.length];
        for (int i = 0; i < tried.length; i++) {
            Arrays.fill(inputs, 4 * i, 4 * i + 4, 0.5f);
            inputs[4 * i + i % 4] = tried[i];
        }
        float[] values = TwinProgram.run(offscreen.gl, "finite.frag", inputs, tried.length, uniforms -> {});
        for (int i = 0; i < tried.length; i++) {
            boolean isKept = Float.isFinite(tried[i]);
            for (int channel = 0; channel < 3; channel++) {
                float given = i % 4 == channel ? tried[i] : 0.5f;
                assertEquals(isKept ? given : 7, values[3 * i + channel], tried[i] + " in channel " + i % 4);
            }
        }
    }

    private static boolean isFinite(float[] radiance) {
        for (float value : radiance) {
            if (!(Math.abs(value) <= 65504)) {
                return false;
            }
        }
        return true;
    }

    @Test
    void radianceIsFiniteWhereHistoryEnds() {
        try (Renderer renderer = load(clouds, CloudHistory.SIXTEEN_FRAMES)) {
            for (int i = 0; i < 8; i++) {
                double turned = 0.9 * i;
                View view = offscreen.view(EYE, EYE.plus(new Vec3(Math.sin(turned), 0.3, -Math.cos(turned))));
                assertTrue(isFinite(drawn(renderer, view)), "turned by " + turned);
            }
        }
    }
}
