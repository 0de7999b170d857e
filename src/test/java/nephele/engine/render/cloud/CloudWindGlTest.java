package nephele.engine.render.cloud;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.measure.HdrFlip;
import nephele.engine.measure.LinearPicture;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.CloudHistory;
import nephele.engine.scene.FrameState;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Frames that share the rays through clouds follow the wind as they follow the eye. */
@TestInstance(Lifecycle.PER_CLASS)
class CloudWindGlTest {
    private static final int WIDTH = 96;
    private static final int HEIGHT = 64;
    private static final double FRAME_SECONDS = 1 / 60.0;
    private static final int FRAMES = 9;
    private static final Vec3 EYE = new Vec3(-10, 10, -14);
    private static final Vec3 AHEAD = new Vec3(0.05, 0.25, -1);
    private static final Vec3 WIND = new Vec3(9, 2, 8);

    private final Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
    private final Level blown = blown(WIND, WIND);
    private final Level calm = blown(Vec3.ZERO, Vec3.ZERO);
    // They keep the clouds sampled for all films of their levels.
    private final Film ofBlown = film(blown, CloudHistory.NONE);
    private final Film ofCalm = film(calm, CloudHistory.NONE);

    @AfterAll
    void close() {
        ofCalm.close();
        ofBlown.close();
        offscreen.close();
    }

    private static TestLevel sky() {
        return new TestLevel()
                .sun(new Vec3(0.4, 0.8, 0.3), 4)
                .sky(new Sky.Gradient(new Vec3(0.1, 0.3, 0.8), new Vec3(0.5, 0.6, 0.8), new Vec3(0.2, 0.2, 0.2)));
    }

    private static Cloud ball(String id, Vec3 centre, Vec3 size, Vec3 wind) {
        return new Cloud(
                id,
                new Cloud.Extent.Volume(centre, size),
                CloudTechnique.AUTO,
                new Cloud.Density.Ellipsoid(),
                0.3,
                1,
                0.6,
                new Cloud.Motion(wind, 0));
    }

    private static Level blown(Vec3 far, Vec3 near) {
        return sky().cloud(ball("far", new Vec3(0, 30, -90), new Vec3(60, 30, 40), far))
                .cloud(ball("side", new Vec3(40, 25, -50), new Vec3(30, 20, 30), far))
                .cloud(ball("near", new Vec3(-14, 14, -32), new Vec3(20, 8, 14), near))
                .level();
    }

    /** A renderer of one level and the state that it draws. */
    private record Film(Offscreen offscreen, Renderer renderer, FrameState state) implements AutoCloseable {
        float[] at(Vec3 eye, double seconds) {
            state.seconds(seconds);
            renderer.draw(offscreen.view(eye, eye.plus(AHEAD)), state, offscreen.picture);
            offscreen.gl.requireNoError("frame");
            return renderer.readRadiance();
        }

        @Override
        public void close() {
            renderer.close();
        }
    }

    private Film film(Level level, CloudHistory history) {
        RenderSettings settings = RenderSettings.of(Output.HDR, Quality.HIGH.with("cloudHistory", history));
        Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings);
        return new Film(offscreen, renderer, FrameState.atStart(level));
    }

    /** Wind is the eye's own motion turned around, to a tenth of a code of 255 on average. */
    @ParameterizedTest
    @EnumSource(
            value = CloudHistory.class,
            names = {"FOUR_FRAMES", "SIXTEEN_FRAMES"})
    void cloudsThatComeAreAsCloudsThatOneGoesTo(CloudHistory history) {
        try (Film windy = film(blown, history);
                Film still = film(calm, history)) {
            for (int frame = 0; frame < FRAMES; frame++) {
                double seconds = frame * FRAME_SECONDS;
                float[] expected = still.at(EYE.addScaled(-seconds, WIND), seconds);
                double codes = 255 * difference(expected, windy.at(EYE, seconds));
                assertTrue(codes <= 0.1, "frame " + frame + ": " + codes + " codes");
            }
        }
    }

    private static double difference(float[] a, float[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += Math.abs(a[i] - b[i]);
        }
        return sum / a.length;
    }

    @Test
    void cloudsThatPassEachOtherLookAsWithAllRays() {
        Level level = blown(new Vec3(12, 0, 0), new Vec3(-6, 0, 3));
        try (Film shared = film(level, CloudHistory.FOUR_FRAMES);
                Film exact = film(level, CloudHistory.NONE)) {
            float[] truth = null;
            float[] seen = null;
            for (int frame = 0; frame < FRAMES; frame++) {
                truth = exact.at(EYE, frame * FRAME_SECONDS);
                seen = shared.at(EYE, frame * FRAME_SECONDS);
            }
            double error = HdrFlip.of(new LinearPicture(WIDTH, HEIGHT, truth), new LinearPicture(WIDTH, HEIGHT, seen))
                    .mean();
            assertTrue(error > 0 && error < 0.012, "FLIP " + error);
        }
    }

    @Test
    void aJumpInTimeIsACut() {
        try (Film played = film(blown, CloudHistory.FOUR_FRAMES);
                Film cold = film(blown, CloudHistory.FOUR_FRAMES)) {
            played.at(EYE, 0);
            played.at(EYE, FRAME_SECONDS);
            for (double seconds : new double[] {3, 0.5}) {
                cold.renderer().forget();
                assertArrayEquals(cold.at(EYE, seconds), played.at(EYE, seconds), "at " + seconds + " s");
            }
        }
    }
}
