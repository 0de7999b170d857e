package nephele.host.compare;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer.StepListener;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.host.compare.CloudComparison.ComparedScenes;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;

/** Two techniques under a wipe: each side is the technique's own picture, bit for bit. */
@TestInstance(Lifecycle.PER_CLASS)
class CloudComparisonGlTest {
    private static final int WIDTH = 64;
    private static final int HEIGHT = 36;
    private static final RenderSettings SETTINGS = RenderSettings.of(Output.HDR);
    private static final TechniquePair BALLS_AND_VOLUME =
            new TechniquePair(CloudTechnique.BILLBOARD, CloudTechnique.VOLUME);

    private final Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
    private final View view = offscreen.view(Vec3.ZERO, new Vec3(0, 10, -120));
    private final Level level = heap(0.05);

    @AfterAll
    void close() {
        offscreen.close();
    }

    private static Level heap(double extinctionPerMetre) {
        return new TestLevel()
                .sky(new Sky.Constant(new Vec3(0.2, 0.3, 0.5)))
                .sun(new Vec3(0.5, 0.6, 0.6), 3)
                .cloud(new Cloud(
                        "heap",
                        new Cloud.Extent.Volume(new Vec3(0, 10, -120), new Vec3(160, 60, 60)),
                        CloudTechnique.AUTO,
                        new Cloud.Density.Puffs(
                                List.of(
                                        new Cloud.Puff(new Vec3(-50, 0, 4), 30),
                                        new Cloud.Puff(new Vec3(40, -2, -10), 34)),
                                null),
                        extinctionPerMetre,
                        0.95,
                        0.6))
                .level();
    }

    private int[] drawnBy(Level drawn, CloudTechnique technique) {
        return offscreen.pixels(TechniquePair.drawnBy(drawn, technique), TestAssets.NONE, view, SETTINGS);
    }

    private static ComparedScenes scenes(Level of, TechniquePair techniques) {
        return ComparedScenes.ofAllClouds(Scene.of(of, TestAssets.NONE), techniques);
    }

    private void draw(CloudComparison comparison) {
        comparison.draw(view, FrameState.atStart(level), WIDTH, HEIGHT, StepListener.NONE);
    }

    private int[] composed(CloudComparison comparison, double share) {
        comparison.compose(new Wipe(share), offscreen.picture);
        offscreen.gl.requireNoError("comparison");
        return offscreen.pixels();
    }

    private static int[] joined(int[] left, int[] right, int column) {
        int[] both = right.clone();
        for (int row = 0; row < HEIGHT; row++) {
            System.arraycopy(left, row * WIDTH, both, row * WIDTH, column);
        }
        return both;
    }

    @Test
    void eachSideIsTheTechniquesOwnPictureAlsoAfterAnEdit() {
        int[] left = drawnBy(level, CloudTechnique.BILLBOARD);
        int[] right = drawnBy(level, CloudTechnique.VOLUME);
        Level thin = heap(0.01);
        int[] thinLeft = drawnBy(thin, CloudTechnique.BILLBOARD);
        int[] thinRight = drawnBy(thin, CloudTechnique.VOLUME);
        var before = offscreen.gl.live().counts();
        try (var comparison = CloudComparison.load(offscreen.gl, scenes(level, BALLS_AND_VOLUME), SETTINGS)) {
            draw(comparison);
            for (int column : new int[] {0, 1, 32, 40, WIDTH}) {
                assertArrayEquals(
                        joined(left, right, column), composed(comparison, column / (double) WIDTH), column + "");
            }
            comparison.edit(scenes(thin, BALLS_AND_VOLUME));
            draw(comparison);
            assertArrayEquals(joined(thinLeft, thinRight, 32), composed(comparison, 0.5));
        }
        assertNotEquals(List.of(left), List.of(right));
        assertEquals(before, offscreen.gl.live().counts(), "nothing is left on the GPU");
    }

    @Test
    void theVolumeIsTheReferenceAndATechniqueDoesNotDifferFromItself() {
        try (var comparison = CloudComparison.load(offscreen.gl, scenes(level, BALLS_AND_VOLUME), SETTINGS)) {
            draw(comparison);
            assertEquals(0, comparison.measureNow().leftMillis(), "the first frame compiles programs");
            draw(comparison);
            ComparisonFigures figures = comparison.measureNow();
            assertTrue(figures.leftMillis() > 0 && figures.rightMillis() > 0, figures.toString());
            PictureDifference billboards = figures.difference();
            assertTrue(billboards.flip() > 0.002 && billboards.flip() < 0.2, billboards.toString());
            assertNotEquals(0, billboards.lightExcess(), billboards.toString());
        }
        var same = new TechniquePair(CloudTechnique.VOLUME, CloudTechnique.VOLUME);
        try (var comparison = CloudComparison.load(offscreen.gl, scenes(level, same), SETTINGS)) {
            draw(comparison);
            assertTrue(comparison.measureNow().difference().isNone());
        }
    }
}
