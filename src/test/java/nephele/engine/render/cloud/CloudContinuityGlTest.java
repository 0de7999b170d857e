package nephele.engine.render.cloud;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudProfile;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.FrameState;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;

/** Clouds neither pop nor swim when the eye or the time changes a little, nor far away. */
@TestInstance(Lifecycle.PER_CLASS)
class CloudContinuityGlTest {
    private static final double CODE = 1.0 / 255;
    private static final Vec3 WIND = new Vec3(12, 0, -5);
    private static final Vec3 UP_AND_AHEAD = new Vec3(-0.2, 0.5, -1);

    private final Offscreen offscreen = new Offscreen(48, 32);
    private final Level calmLevel = level(0.05, Vec3.ZERO, 0);
    private final Drawing calm = Drawing.of(offscreen, calmLevel);

    @AfterAll
    void close() {
        calm.close();
        offscreen.close();
    }

    private static Level level(double extinctionPerMetre, Vec3 wind, double evolutionSeconds) {
        return new TestLevel()
                .sun(new Vec3(0.5, 0.7, -0.3), 2)
                .sky(new Sky.Gradient(new Vec3(0.1, 0.2, 0.6), new Vec3(0.4, 0.5, 0.6), new Vec3(0.1, 0.1, 0.1)))
                .cloud(new Cloud(
                        "heaps",
                        new Cloud.Extent.Layer(800, 500),
                        CloudTechnique.AUTO,
                        new Cloud.Density.Noise(5, 300, 0.5, 0.3, CloudProfile.CUMULUS, null, 0),
                        extinctionPerMetre,
                        1,
                        0.85,
                        new Cloud.Motion(wind, evolutionSeconds)))
                .level();
    }

    /** A renderer of one level that draws small pictures. */
    private record Drawing(Offscreen offscreen, Renderer renderer) implements AutoCloseable {
        /** Loads a level with clouds that no other drawing uses: those of other assets are other ones. */
        static Drawing of(Offscreen offscreen, Level level) {
            RenderSettings settings = RenderSettings.of(Output.HDR, Quality.HIGH);
            return new Drawing(offscreen, LevelRenderer.load(offscreen.gl, level, new TestAssets(), settings));
        }

        float[] at(Vec3 eye, double seconds) {
            FrameState state = FrameState.atStart(renderer.scene().level());
            state.seconds(seconds);
            renderer.forget();
            renderer.draw(offscreen.view(eye, eye.plus(UP_AND_AHEAD)), state, offscreen.picture);
            offscreen.gl.requireNoError("frame");
            return renderer.readRadiance();
        }

        @Override
        public void close() {
            renderer.close();
        }
    }

    private static double difference(float[] a, float[] b) {
        double squares = 0;
        for (int i = 0; i < a.length; i++) {
            squares += (a[i] - b[i]) * (a[i] - b[i]);
        }
        return Math.sqrt(squares / a.length);
    }

    private static void requireSame(float[] expected, float[] found, String what) {
        double difference = difference(expected, found);
        assertTrue(difference <= CODE, what + ": " + difference / CODE + " codes");
    }

    /** The boxes of cells move while the eye goes; the picture does not tell where they have been. */
    @Test
    void whereTheEyeCameFromCannotBeSeen() {
        var end = new Vec3(700, 2, -330);
        try (Drawing cold = Drawing.of(offscreen, calmLevel)) {
            float[] direct = cold.at(end, 0);
            calm.at(Vec3.ZERO, 0);
            calm.at(end.scaled(0.5), 0);
            float[] walked = calm.at(end, 0);
            requireSame(direct, walked, "after a walk");
            requireSame(walked, calm.at(end.plus(new Vec3(0.001, 0, 0)), 0), "a step of 1 mm");
        }
    }

    @Test
    void timeFlowsThroughTheSamples() {
        // A generation of noise in 80 s: a sample every 10 s.
        try (Drawing drawing = Drawing.of(offscreen, level(0.05, Vec3.ZERO, 80))) {
            float[] before = drawing.at(Vec3.ZERO, 19.999);
            requireSame(before, drawing.at(Vec3.ZERO, 20), "the sampled time");
            requireSame(before, drawing.at(Vec3.ZERO, 20.001), "a moment after it");
            assertTrue(difference(before, drawing.at(Vec3.ZERO, 30)) > 4 * CODE, "the clouds change");
        }
    }

    /** After thirty days the wind has blown 33,000 km. */
    @Test
    void whoDriftsWithTheWindForAMonthSeesTheSame() {
        double month = 30 * 86_400;
        try (Drawing windy = Drawing.of(offscreen, level(0.05, WIND, 0))) {
            float[] start = calm.at(Vec3.ZERO, 0);
            requireSame(start, windy.at(WIND.scaled(month), month), "a month later");
            assertTrue(difference(start, windy.at(Vec3.ZERO, 60)) > 4 * CODE, "one at rest sees other clouds");
        }
    }

    @Test
    void cloudsOfNoExtinctionLeaveEveryBit() {
        Level without = new TestLevel()
                .sun(new Vec3(0.5, 0.7, -0.3), 2)
                .sky(new Sky.Gradient(new Vec3(0.1, 0.2, 0.6), new Vec3(0.4, 0.5, 0.6), new Vec3(0.1, 0.1, 0.1)))
                .level();
        try (Drawing none = Drawing.of(offscreen, without);
                Drawing thin = Drawing.of(offscreen, level(0, Vec3.ZERO, 0))) {
            assertArrayEquals(none.at(Vec3.ZERO, 0), thin.at(Vec3.ZERO, 0));
        }
    }
}
