package nephele.engine.render.cloud;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.ChosenTechniques;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.cloud.drawn.TechniqueFade;
import nephele.engine.level.Camera;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.measure.HdrFlip;
import nephele.engine.measure.LinearPicture;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.GlKind;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** An edit that makes a cloud reachable: its techniques go over without a step. */
@TestInstance(Lifecycle.PER_CLASS)
class TechniqueFadeGlTest {
    private static final int WIDTH = 80;
    private static final int HEIGHT = 45;
    private static final double FRAME = 1.0 / 60;
    private static final Vec3 MIDDLE = new Vec3(0, 10, -120);

    private final Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
    private final View view = offscreen.view(Vec3.ZERO, MIDDLE);

    @AfterAll
    void close() {
        offscreen.close();
    }

    private static Level level(double extinctionPerMetre, double albedo, Vec3 camera) {
        var cloud = new Cloud(
                        "heap",
                        new Cloud.Extent.Volume(MIDDLE, new Vec3(160, 60, 60)),
                        CloudTechnique.AUTO,
                        new Cloud.Density.Puffs(
                                List.of(
                                        new Cloud.Puff(new Vec3(-50, 0, 4), 30),
                                        new Cloud.Puff(new Vec3(0, 12, 14), 26),
                                        new Cloud.Puff(new Vec3(40, -2, -10), 34)),
                                null),
                        extinctionPerMetre,
                        albedo,
                        0.6)
                .with(new Cloud.Tolerance(1000, 60));
        Level clouded = new TestLevel()
                .sky(new Sky.Constant(new Vec3(0.2, 0.3, 0.5)))
                .sun(new Vec3(0.5, 0.6, 0.6), 3)
                .cloud(cloud)
                .material("stone", new Vec3(0.5, 0.5, 0.5))
                .box("stone", new Vec3(0, -3.5, 0), new Vec3(8, 1, 8))
                .level();
        Vec3 ahead = camera.plus(new Vec3(0, 0, -1));
        var only = new Camera("main", camera, ahead, new Vec3(0, 1, 0), 60, 0, 0.1, 1e4, List.of());
        return Level.of("fade", "", clouded.environment(), List.of(only))
                .with(clouded.materials(), clouded.solids())
                .with(new PlayerStart(new Vec3(0, -3, 0), 0, 0), null);
    }

    private static Level outside(double extinctionPerMetre, double albedo) {
        return level(extinctionPerMetre, albedo, Vec3.ZERO);
    }

    /** The same clouds, one of which an eye can be in. */
    private static Level inside(double extinctionPerMetre, double albedo) {
        return level(extinctionPerMetre, albedo, MIDDLE);
    }

    private static CloudTechnique technique(Level level) {
        return ChosenTechniques.of(PlacedLevel.of(level, TestAssets.NONE))
                .techniques()
                .get(0);
    }

    private Renderer load(Level level) {
        return LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, RenderSettings.of(Output.HDR));
    }

    private static Scene edited(Renderer renderer, Level level) {
        Scene before = renderer.scene();
        return before.edited(new PlacedLevel(level, before.assets(), before.statics()), before.light());
    }

    private LinearPicture drawn(Renderer renderer) {
        renderer.forget();
        renderer.draw(view, offscreen.picture);
        offscreen.gl.requireNoError("frame");
        return new LinearPicture(WIDTH, HEIGHT, renderer.readRadiance());
    }

    private LinearPicture loaded(Level level) {
        try (Renderer renderer = load(level)) {
            return drawn(renderer);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.3})
    void noFrameOfAChangeIsAStep(double extinctionPerMetre) {
        Level far = outside(extinctionPerMetre, 1);
        Level near = inside(extinctionPerMetre, 1);
        assertNotEquals(technique(far), technique(near));
        LinearPicture old = loaded(far);
        LinearPicture other = loaded(near);
        Renderer renderer = load(far);
        try {
            renderer = LevelRenderer.editedGradually(renderer, edited(renderer, near));
            LinearPicture before = drawn(renderer);
            assertArrayEquals(old.rgb(), before.rgb(), "the first frame shows the old technique");
            int frames = 0;
            while (renderer.changed() < 1) {
                renderer.elapse(FRAME);
                LinearPicture now = drawn(renderer);
                double step = HdrFlip.of(before, now).mean();
                assertTrue(step <= 0.02, () -> "step " + step);
                before = now;
                frames++;
            }
            assertEquals(TechniqueFade.SECONDS / FRAME, frames, 1);
            assertArrayEquals(other.rgb(), before.rgb(), "the last frame shows the new one alone");
        } finally {
            renderer.close();
        }
    }

    /** Black clouds before an even sky: what passes is all that is seen. */
    @Test
    void whatPassesThroughStaysTheSame() {
        Level far = outside(0.05, 0);
        Renderer renderer = load(far);
        try {
            LinearPicture old = drawn(renderer);
            renderer = LevelRenderer.editedGradually(renderer, edited(renderer, inside(0.05, 0)));
            while (renderer.changed() < 1) {
                renderer.elapse(0.2);
                assertEquals(0, rootMeanSquare(old, drawn(renderer)), 0.01);
            }
        } finally {
            renderer.close();
        }
    }

    private static double rootMeanSquare(LinearPicture sky, LinearPicture other) {
        double sum = 0;
        for (int i = 0; i < sky.rgb().length; i += 3) {
            double passing = (sky.rgb()[i] - other.rgb()[i]) / 0.2;
            sum += passing * passing;
        }
        return Math.sqrt(sum / (sky.rgb().length / 3.0));
    }

    @Test
    void aChangeLeavesNothingBehindAndOtherEditsAreCompleteAtOnce() {
        Level far = outside(0.05, 1);
        Level near = inside(0.05, 1);
        Renderer renderer = load(near);
        try {
            drawn(renderer);
            Map<GlKind, Integer> alone = offscreen.gl.live().counts();
            renderer = LevelRenderer.edited(renderer, edited(renderer, far));
            assertEquals(1, renderer.changed());
            assertArrayEquals(loaded(far).rgb(), drawn(renderer).rgb());
            renderer = LevelRenderer.editedGradually(renderer, edited(renderer, near));
            renderer.elapse(0.5);
            drawn(renderer);
            assertNotEquals(alone, offscreen.gl.live().counts());
            // An edit meanwhile continues the change.
            double reached = renderer.changed();
            renderer = LevelRenderer.editedGradually(renderer, edited(renderer, near));
            assertEquals(reached, renderer.changed());
            renderer.elapse(Double.POSITIVE_INFINITY);
            drawn(renderer);
            assertEquals(alone, offscreen.gl.live().counts());
        } finally {
            renderer.close();
        }
    }
}
