package nephele.engine.render.cloud;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.cloud.field.PuffsField;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.ImpostorChoice;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Clouds of soft balls that are drawn from pictures of them. */
@TestInstance(Lifecycle.PER_CLASS)
@Order(1) // one of the longest
class ImpostorGlTest {
    private static final int WIDTH = 96;
    private static final int HEIGHT = 54;
    private static final Vec3 CENTRE = new Vec3(0, 10, -140);
    private static final Quality EXACT = Quality.ULTRA.with("samples", 1).with("impostors", ImpostorChoice.AUTO);
    private static final List<Cloud.Puff> HEAP = heap();

    private final Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);

    @AfterAll
    void close() {
        offscreen.close();
    }

    /** Balls in a helix, so that none hides another one wholly and the cloud has several slabs. */
    private static List<Cloud.Puff> heap() {
        List<Cloud.Puff> puffs = new ArrayList<>();
        for (int i = 0; i < 12; i++) {
            puffs.add(new Cloud.Puff(new Vec3(22 * Math.cos(i), 2.0 * i - 12, 22 * Math.sin(i)), 12));
        }
        return puffs;
    }

    private static TestLevel under(double sky, double sun, double perMetre, double albedo, CloudTechnique technique) {
        return new TestLevel()
                .sky(new Sky.Constant(TestLevel.grey(sky)))
                .sun(new Vec3(0.5, 0.6, 0.6), sun)
                .cloud(new Cloud(
                        "heap",
                        new Cloud.Extent.Volume(CENTRE, new Vec3(80, 60, 80)),
                        technique,
                        new Cloud.Density.Puffs(HEAP, null),
                        perMetre,
                        albedo,
                        0.85));
    }

    /** The triangles of the last frame. */
    private long triangles;

    /** Returns the last of several frames; the eye moves to the right by so much from one to the next. */
    private float[] lastOf(int frames, double step, Level level, Quality quality) {
        try (Renderer renderer =
                LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, RenderSettings.of(Output.HDR, quality))) {
            for (int frame = 0; frame < frames; frame++) {
                offscreen.gl.state().resetCounts();
                renderer.draw(view(step * frame), offscreen.picture);
                triangles = offscreen.gl.state().triangles();
            }
            offscreen.gl.requireNoError("frame");
            return renderer.readRadiance();
        }
    }

    private View view(double x) {
        return offscreen.view(new Vec3(x, 0, 0), CENTRE);
    }

    /** Balls that scatter nothing show how much of the white sky passes; the picture is a few frames old. */
    @ParameterizedTest
    @CsvSource({"PARTICLES, 0.02", "PARTICLES, 0.3", "BILLBOARD, 0.02"})
    void whatPassesIsTheClosedForm(CloudTechnique technique, double perMetre) {
        float[] seen = lastOf(6, 0.1, under(1, 0, perMetre, 0, technique).level(), EXACT);
        assertTrue(triangles < 2 * HEAP.size(), "drawn from a picture: " + triangles);
        var field = new PuffsField(HEAP, CENTRE, perMetre);
        double squares = 0;
        int count = 0;
        View view = view(0.5);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            Ray ray = Ray.of(view.eye(), offscreen.ray(view, i));
            double depth = field.closedDepth(ray, 0, Double.POSITIVE_INFINITY).orElseThrow();
            if (depth > 0.01) {
                double error = seen[3 * i] - Math.exp(-depth);
                squares += error * error;
                count++;
            }
        }
        assertTrue(count > 100, count + " pixels");
        assertEquals(0, Math.sqrt(squares / count), 0.01);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.5, 1000})
    void aWhiteFurnaceIsWhite(double perMetre) {
        Level level = under(1, 0, perMetre, 1, CloudTechnique.PARTICLES).level();
        for (float value :
                lastOf(6, 0.1, level, perMetre == 0.5 ? Quality.LOW.with("impostors", ImpostorChoice.AUTO) : EXACT)) {
            assertEquals(1, value, 1 / 255.0);
        }
    }

    @Test
    void withoutDepthNothingIsDrawn() {
        Level without = new TestLevel()
                .sky(new Sky.Constant(TestLevel.grey(0.7)))
                .sun(new Vec3(0.5, 0.6, 0.6), 3)
                .level();
        Level with = under(0.7, 3, 0, 1, CloudTechnique.PARTICLES).level();
        assertArrayEquals(lastOf(1, 0, without, Quality.HIGH), lastOf(4, 0, with, Quality.HIGH));
    }

    /** A wall in the cloud hides what is behind it and nothing else, whether clouds have a layer or not. */
    @ParameterizedTest
    @CsvSource({"0.5", "1"})
    void aSurfaceInTheCloudIsAmongItsBalls(double resolution) {
        Level level = under(0.3, 4, 0.05, 1, CloudTechnique.PARTICLES)
                .material("dark", TestLevel.grey(0.05))
                .box("dark", CENTRE, new Vec3(30, 30, 2))
                .level();
        assertSameAsDirectly(
                level,
                Quality.HIGH.with("cloudResolution", resolution).with("cloudHistory", Quality.CloudHistory.NONE));
    }

    private void assertSameAsDirectly(Level level, Quality quality) {
        float[] direct = lastOf(5, 0.1, level, quality.with("impostors", ImpostorChoice.OFF));
        float[] seen = lastOf(5, 0.1, level, quality.with("impostors", ImpostorChoice.AUTO));
        for (int i = 0; i < direct.length; i++) {
            assertEquals(direct[i], seen[i], 0.03 * Math.max(0.3, direct[i]), "value " + i);
        }
    }

    /** The eye behind a portal is 2 m beside the other one, for which the picture is made; or among the balls. */
    @ParameterizedTest
    @ValueSource(doubles = {-6, -120})
    void aPortalShowsTheCloudBehindIt(double exit) {
        Level level = under(0.3, 4, 0.05, 1, CloudTechnique.PARTICLES)
                .portal("a", "b", new Vec3(0, 0, -6), new Vec3(0, 0, 1), 3, 3)
                .portal("b", "a", new Vec3(2, 0, exit), new Vec3(0, 0, -1), 3, 3)
                .level();
        assertSameAsDirectly(level, EXACT);
        long fewer = -triangles;
        lastOf(1, 0, level, EXACT.with("impostors", ImpostorChoice.OFF));
        fewer += triangles;
        assertTrue(exit == -6 ? fewer > 2 * HEAP.size() : fewer > 0, fewer + " triangles fewer");
    }

    /** A frame adds balls to pictures up to its limit, draws the cloud directly meanwhile, and is never incomplete. */
    @Test
    void picturesAreMadeOverSeveralFrames() {
        List<Cloud.Puff> many = new ArrayList<>();
        for (int i = 0; i < 12; i++) {
            // The small one asks for fine texels, of which the large ones then need many.
            many.addAll(HEAP);
            many.add(new Cloud.Puff(new Vec3(0, 2.0 * i - 12, 0), 4));
            many.add(new Cloud.Puff(new Vec3(3, 2.0 * i - 12, 0), 4));
        }
        Level level = new TestLevel()
                .sky(new Sky.Constant(TestLevel.grey(0.3)))
                .sun(new Vec3(0.5, 0.6, 0.6), 4)
                .cloud(new Cloud(
                        "heap",
                        new Cloud.Extent.Volume(CENTRE, new Vec3(80, 60, 80)),
                        CloudTechnique.PARTICLES,
                        new Cloud.Density.Puffs(many, null),
                        0.05,
                        1,
                        0.85))
                .level();
        try (var large = RenderTarget.picture(offscreen.gl, "large", PixelFormat.RGBA8, 444, 250);
                Renderer renderer = LevelRenderer.load(
                        offscreen.gl, level, TestAssets.NONE, RenderSettings.of(Output.HDR, EXACT))) {
            List<Long> counts = new ArrayList<>();
            for (int frame = 0; frame < 5; frame++) {
                offscreen.gl.state().resetCounts();
                renderer.draw(view(0), large);
                counts.add(offscreen.gl.state().triangles());
            }
            long captured = (counts.get(1) - counts.get(0)) / 2;
            assertTrue(captured > 30 && captured < 0.75 * many.size(), captured + " balls in a frame");
            assertTrue(counts.get(4) < 60, "drawn from pictures: " + counts);
        }
    }

    /** A picture that is made for another eye is never shown: the frame has all balls, to the bit. */
    @Test
    void anEyeThatHasMovedTooFarSeesTheBalls() {
        Level level = under(0.3, 4, 0.05, 1, CloudTechnique.PARTICLES).level();
        float[] direct;
        try (Renderer renderer =
                LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, RenderSettings.of(Output.HDR, EXACT))) {
            renderer.draw(view(40), offscreen.picture);
            direct = renderer.readRadiance();
            for (int frame = 0; frame < 3; frame++) {
                renderer.draw(view(0), offscreen.picture);
            }
            renderer.draw(view(40), offscreen.picture);
            assertArrayEquals(direct, renderer.readRadiance());
        }
    }

    /** The first frame after a cut is that of a renderer that has drawn nothing else. */
    @Test
    void aCutForgetsPictures() {
        Level level = under(0.3, 4, 0.05, 1, CloudTechnique.PARTICLES).level();
        float[] cold = lastOf(1, 0, level, Quality.HIGH);
        var settings = RenderSettings.of(Output.HDR, Quality.HIGH);
        try (Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings)) {
            for (int frame = 0; frame < 4; frame++) {
                renderer.draw(view(0.5), offscreen.picture);
            }
            renderer.forget();
            renderer.draw(view(0), offscreen.picture);
            assertArrayEquals(cold, renderer.readRadiance());
        }
    }
}
