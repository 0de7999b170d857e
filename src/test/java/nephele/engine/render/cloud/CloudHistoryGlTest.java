package nephele.engine.render.cloud;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.asset.TestAssets;
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
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Frames that share the rays through clouds show what a frame with all rays shows, and nothing from before a cut. */
class CloudHistoryGlTest {
    private static final int WIDTH = 144;
    private static final int HEIGHT = 96;
    private static final Vec3 EYE = new Vec3(0, 2, 5);

    private static TestLevel clouds() {
        return new TestLevel()
                .sun(new Vec3(0.4, 0.8, 0.3), 4)
                .ambient(0.4)
                .sky(new Sky.Gradient(new Vec3(0.1, 0.3, 0.8), new Vec3(0.5, 0.6, 0.8), new Vec3(0.2, 0.2, 0.2)))
                .material("wall", new Vec3(0.5, 0.4, 0.3))
                .box("wall", new Vec3(0, -0.5, 0), new Vec3(8, 1, 20))
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

    private static Renderer load(Offscreen offscreen, Level level, CloudHistory history) {
        Quality quality = Quality.HIGH.withCloudHistory(history);
        return Renderer.load(offscreen.gl, level, TestAssets.NONE, RenderSettings.of(Output.HDR, quality));
    }

    private static float[] drawn(Offscreen offscreen, Renderer renderer, View view) {
        renderer.draw(view, offscreen.picture);
        offscreen.gl.requireNoError("frame");
        return renderer.readRadiance();
    }

    private static float[] alone(Offscreen offscreen, Renderer renderer, View view) {
        renderer.forget();
        return drawn(offscreen, renderer, view);
    }

    /** Returns the views of an eye that turns by degrees and advances a little. */
    private static List<View> flight(Offscreen offscreen, Vec3 from, double metresAFrame) {
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
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer renderer = load(offscreen, clouds().level(), history)) {
            View view = offscreen.view(EYE, new Vec3(0, 8, -20));
            float[] first = drawn(offscreen, renderer, view);
            for (int frame = 1; frame <= 17; frame++) {
                assertArrayEquals(first, drawn(offscreen, renderer, view), "frame " + frame);
            }
        }
    }

    @Test
    void framesAfterACutAreThoseOfAColdStart() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer cold = load(offscreen, clouds().level(), CloudHistory.FOUR_FRAMES);
                Renderer warm = load(offscreen, clouds().level(), CloudHistory.FOUR_FRAMES)) {
            for (int i = 0; i < 6; i++) {
                drawn(offscreen, warm, offscreen.view(new Vec3(9, 3, i), new Vec3(-20, 20, -60)));
            }
            warm.forget();
            boolean differs = false;
            List<View> flight = flight(offscreen, EYE, 0.3);
            for (View view : flight) {
                float[] frame = drawn(offscreen, cold, view);
                assertArrayEquals(frame, drawn(offscreen, warm, view));
                differs |= !Arrays.equals(frame, drawnWithAllRays(offscreen, view));
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
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer tested = load(offscreen, near, CloudHistory.FOUR_FRAMES);
                Renderer read = load(offscreen, far, CloudHistory.FOUR_FRAMES)) {
            for (View view : flight(offscreen, EYE, 0.3).subList(0, 3)) {
                assertArrayEquals(drawn(offscreen, read, view), drawn(offscreen, tested, view));
            }
        }
    }

    private static float[] drawnWithAllRays(Offscreen offscreen, View view) {
        try (Renderer renderer = load(offscreen, clouds().level(), CloudHistory.NONE)) {
            return drawn(offscreen, renderer, view);
        }
    }

    @Test
    void aPassageThroughAPortalIsACut() {
        Level level = withPortals();
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer cold = load(offscreen, level, CloudHistory.FOUR_FRAMES);
                Renderer warm = load(offscreen, level, CloudHistory.FOUR_FRAMES)) {
            for (double z = -6.5; z > -7.5; z -= 0.25) {
                Vec3 eye = new Vec3(0.5, 2, z);
                drawn(offscreen, warm, offscreen.view(eye, eye.plus(new Vec3(0, 0.1, -1))));
            }
            // Both portals face +z: what enters one towards -z leaves the other towards +z.
            for (double z = 9.75; z < 11; z += 0.25) {
                Vec3 eye = new Vec3(-0.5, 2, z);
                View view = offscreen.view(eye, eye.plus(new Vec3(0.1 * (z - 9.5), 0.3, 1)));
                assertArrayEquals(drawn(offscreen, cold, view), drawn(offscreen, warm, view), "z " + z);
            }
        }
    }

    /** The eye advances 12 m/s at 60 frames a second, past one cloud and through its edge. */
    @ParameterizedTest
    @EnumSource(
            value = CloudHistory.class,
            names = {"FOUR_FRAMES", "SIXTEEN_FRAMES"})
    void aFlightLooksAsWithAllRays(CloudHistory history) {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer shared = load(offscreen, clouds().level(), history);
                Renderer exact = load(offscreen, clouds().level(), CloudHistory.NONE)) {
            boolean isFew = history == CloudHistory.FOUR_FRAMES;
            LinearPicture truthBefore = null;
            LinearPicture seenBefore = null;
            for (View view : flight(offscreen, new Vec3(-10, 10, -14), 0.2)) {
                LinearPicture truth = picture(alone(offscreen, exact, view));
                LinearPicture seen = picture(drawn(offscreen, shared, view));
                double error = HdrFlip.of(truth, seen).mean();
                assertTrue(error < (isFew ? 0.012 : 0.025), view + ": FLIP " + error);
                if (truthBefore != null) {
                    double step = HdrFlip.of(seenBefore, seen).mean();
                    double least = HdrFlip.of(truthBefore, truth).mean();
                    assertTrue(step < least + (isFew ? 0.01 : 0.02), view + ": step " + step + " for " + least);
                }
                truthBefore = truth;
                seenBefore = seen;
            }
        }
    }

    private static LinearPicture picture(float[] rgb) {
        return new LinearPicture(WIDTH, HEIGHT, rgb);
    }

    @Test
    void aSmallerPictureBeginsAnew() {
        try (Offscreen large = new Offscreen(WIDTH, HEIGHT);
                Renderer renderer = load(large, clouds().level(), CloudHistory.FOUR_FRAMES);
                Renderer cold = load(large, clouds().level(), CloudHistory.FOUR_FRAMES)) {
            drawn(large, renderer, large.view(EYE, new Vec3(0, 8, -20)));
            RenderTarget small = RenderTarget.picture(large.gl, "small", PixelFormat.RGBA8, 33, 21);
            View view = large.view(new Vec3(3, 2, 5), new Vec3(0, 9, -20));
            renderer.draw(view, small);
            cold.draw(view, small);
            assertArrayEquals(cold.readRadiance(), renderer.readRadiance());
            small.close();
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
        float[] values = TwinProgram.run("finite.frag", inputs, tried.length, uniforms -> {});
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
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer renderer = load(offscreen, clouds().level(), CloudHistory.SIXTEEN_FRAMES)) {
            for (int i = 0; i < 8; i++) {
                double turned = 0.9 * i;
                View view = offscreen.view(EYE, EYE.plus(new Vec3(Math.sin(turned), 0.3, -Math.cos(turned))));
                assertTrue(isFinite(drawn(offscreen, renderer, view)), "turned by " + turned);
            }
        }
    }
}
