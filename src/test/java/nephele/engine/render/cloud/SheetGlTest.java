package nephele.engine.render.cloud;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.cloud.octave.ProceduralNoise;
import nephele.engine.level.Cloud;
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
import nephele.engine.render.frame.Quality.CloudHistory;
import nephele.engine.render.frame.Quality.SkyplaneShape;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.View;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Clouds that are drawn as sheets, from columns and from octaves of noise. */
@TestInstance(Lifecycle.PER_CLASS)
class SheetGlTest {
    private static final int WIDTH = 48;
    private static final int HEIGHT = 27;
    /** For the many boxes of layers. */
    private static final int COARSE_LIGHT = 8;

    private static final double BASE = 900;
    private static final double THICK = 200;
    private static final double MIDDLE = BASE + THICK / 2;
    private static final Cloud.Density EVEN = new Cloud.Density.Ellipsoid();
    private static final Cloud.Density PATCHES = new Cloud.Density.Noise(3, 1500, 0.5);
    private static final Quality EXACT = Quality.ULTRA.with("samples", 1);

    private final Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);

    @AfterAll
    void close() {
        offscreen.close();
    }

    private static Cloud layer(
            CloudTechnique technique, Cloud.Density density, double depth, double albedo, Cloud.Motion motion) {
        return new Cloud(
                "layer", new Cloud.Extent.Layer(BASE, THICK), technique, density, depth / THICK, albedo, 0.85, motion);
    }

    private static Cloud layer(CloudTechnique technique, Cloud.Density density, double depth, double albedo) {
        return layer(technique, density, depth, albedo, Cloud.Motion.STILL);
    }

    private static TestLevel white() {
        return new TestLevel().sky(new Sky.Constant(TestLevel.grey(1)));
    }

    private static TestLevel sunny() {
        return new TestLevel()
                .sun(new Vec3(0.4, 0.8, 0.3), 3)
                .sky(new Sky.Gradient(new Vec3(0.1, 0.3, 0.8), new Vec3(0.5, 0.6, 0.8), new Vec3(0.2, 0.2, 0.2)));
    }

    private Renderer load(Level level, Quality quality) {
        Quality coarse = quality.with("cloudLightCell", COARSE_LIGHT);
        return LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, RenderSettings.of(Output.HDR, coarse));
    }

    private float[] drawn(Renderer renderer, View view) {
        renderer.forget();
        renderer.draw(view, offscreen.picture);
        offscreen.gl.requireNoError("frame");
        return renderer.readRadiance();
    }

    private View view(double height, double rise) {
        Vec3 eye = new Vec3(0, height, 0);
        return offscreen.view(eye, eye.plus(new Vec3(0.1, rise, -1)));
    }

    static Stream<Arguments> furnaces() {
        return Stream.of(CloudTechnique.SKYPLANE, CloudTechnique.PROCEDURAL)
                .flatMap(technique -> Stream.of(
                        Arguments.of(technique, Quality.LOW, 1.0),
                        Arguments.of(technique, Quality.MEDIUM, 1e-3),
                        Arguments.of(technique, Quality.HIGH, 100.0),
                        Arguments.of(technique, EXACT, 1e4)));
    }

    @ParameterizedTest
    @MethodSource("furnaces")
    void aWhiteFurnaceIsWhite(CloudTechnique technique, Quality quality, double depth) {
        try (Renderer renderer =
                load(white().cloud(layer(technique, PATCHES, depth, 1)).level(), quality)) {
            for (double height : List.of(0.0, MIDDLE, MIDDLE + 30, 2000.0)) {
                for (float value : drawn(renderer, view(height, height > MIDDLE ? -0.4 : 0.4))) {
                    assertEquals(1, value, 1 / 255.0, () -> "from " + height);
                }
            }
        }
    }

    @ParameterizedTest
    @EnumSource(names = {"SKYPLANE", "PROCEDURAL"})
    void aCloudWithoutDepthIsNotDrawn(CloudTechnique technique) {
        Cloud gone = new Cloud(
                "gone",
                new Cloud.Extent.Volume(new Vec3(0, 500, -200), new Vec3(90, 90, 90)),
                technique,
                new Cloud.Density.Noise(1, 300, 0),
                0.1,
                1,
                0.85);
        assertNotDrawn(gone, Quality.HIGH);
        for (Quality quality : List.of(Quality.LOW, Quality.MEDIUM, Quality.HIGH, Quality.ULTRA)) {
            assertNotDrawn(layer(technique, EVEN, 0, 1), quality);
        }
    }

    private void assertNotDrawn(Cloud cloud, Quality quality) {
        try (Renderer bare = load(sunny().level(), quality);
                Renderer clouded = load(sunny().cloud(cloud).level(), quality)) {
            assertArrayEquals(drawn(bare, view(0, 0.5)), drawn(clouded, view(0, 0.5)));
        }
    }

    /** @return the root mean square over all pixels of what is drawn less a function of the ray's sine of elevation */
    private double error(Renderer renderer, View view, ToDoubleFunction<Vec3> expected) {
        float[] drawn = drawn(renderer, view);
        double squares = 0;
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            double error = drawn[3 * i] - expected.applyAsDouble(offscreen.ray(view, i));
            squares += error * error;
        }
        return Math.sqrt(squares / (WIDTH * HEIGHT));
    }

    /** An absorbing even layer before a white sky: exp(−τ/µ), along the normal as near the horizon, from both sides. */
    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.3, 3})
    void anEvenLayerObeysBeersLaw(double depth) {
        Level level =
                white().cloud(layer(CloudTechnique.SKYPLANE, EVEN, depth, 0)).level();
        ToDoubleFunction<Vec3> below = ray -> ray.y() > 0 ? Math.exp(-depth / ray.y()) : 1;
        ToDoubleFunction<Vec3> above = ray -> ray.y() < 0 ? Math.exp(depth / ray.y()) : 1;
        try (Renderer renderer = load(level, EXACT)) {
            assertEquals(0, error(renderer, view(0, 8), below), 0.002, "zenith");
            assertEquals(0, error(renderer, view(0, 0.6), below), 0.002, "slant");
            assertEquals(0, error(renderer, view(0, 0.02), below), 0.01, "horizon");
            assertEquals(0, error(renderer, view(2000, -8), above), 0.002, "nadir");
            assertEquals(0, error(renderer, view(2000, -0.05), above), 0.01, "horizon from above");
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.2, 2})
    void anEvenLayerIsAsBrightAsTheVolume(double depth) {
        try (Renderer sheet = load(
                        sunny().cloud(layer(CloudTechnique.SKYPLANE, EVEN, depth, 1))
                                .level(),
                        EXACT);
                Renderer volume = load(
                        sunny().cloud(layer(CloudTechnique.VOLUME, EVEN, depth, 1))
                                .level(),
                        EXACT)) {
            for (double rise : List.of(0.7, 3.0)) {
                assertEquals(1, mean(drawn(sheet, view(0, rise))) / mean(drawn(volume, view(0, rise))), 0.1);
                assertEquals(1, mean(drawn(sheet, view(2000, -rise))) / mean(drawn(volume, view(2000, -rise))), 0.1);
            }
        }
    }

    private static double mean(float[] values) {
        double sum = 0;
        for (float value : values) {
            sum += value;
        }
        return sum / values.length;
    }

    static Stream<Arguments> kinds() {
        return Stream.concat(
                Stream.of(SkyplaneShape.values())
                        .map(shape -> Arguments.of(CloudTechnique.SKYPLANE, EXACT.with("skyplaneShape", shape))),
                Stream.of(ProceduralNoise.values())
                        .map(noise -> Arguments.of(CloudTechnique.PROCEDURAL, EXACT.with("proceduralNoise", noise))));
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void everywhereAllIsFinite(CloudTechnique technique, Quality quality) {
        Level level = sunny().cloud(layer(technique, PATCHES, 1e4, 0.9)).level();
        try (Renderer renderer = load(level, quality)) {
            for (double height : List.of(0.0, BASE, MIDDLE, MIDDLE + 1e-3, 5000.0)) {
                for (double rise : List.of(-9.0, 0.0, 9.0)) {
                    for (float value : drawn(renderer, view(height, rise))) {
                        assertTrue(value >= 0 && value < 1e4, () -> value + " from " + height + " along " + rise);
                    }
                }
            }
        }
    }

    @Test
    void aThickLayerIsOpaque() {
        try (Renderer renderer =
                load(white().cloud(layer(CloudTechnique.SKYPLANE, EVEN, 1e4, 0)).level(), EXACT)) {
            assertArrayEquals(new float[3 * WIDTH * HEIGHT], drawn(renderer, view(0, 3)));
        }
    }

    @Test
    void nothingPopsWhereTheEyeCrossesTheSheet() {
        Level level = sunny().cloud(layer(CloudTechnique.SKYPLANE, EVEN, 1, 1)).level();
        try (Renderer renderer = load(level, EXACT)) {
            for (double height : List.of(BASE, MIDDLE, BASE + THICK)) {
                float[] before = drawn(renderer, view(height - 1e-3, 0.1));
                float[] after = drawn(renderer, view(height + 1e-3, 0.1));
                assertArrayEquals(before, after, 1 / 255f);
            }
        }
    }

    /** The wind carries the pattern 1,000 km in 30 days, and the eye goes with it. */
    @ParameterizedTest
    @EnumSource(names = {"SKYPLANE", "PROCEDURAL"})
    void farAwayAndLongAfterThePictureIsTheSame(CloudTechnique technique) {
        double days = 30 * 86400;
        Vec3 way = new Vec3(1e6, 0, -1e6);
        Level level = sunny().cloud(layer(technique, PATCHES, 3, 1, new Cloud.Motion(way.scaled(1 / days), 0)))
                .level();
        FrameState state = FrameState.atStart(level);
        try (Renderer renderer = load(level, EXACT)) {
            float[] first = at(renderer, state, Vec3.ZERO, 0);
            float[] last = at(renderer, state, way, days);
            assertArrayEquals(first, last, 1 / 255f);
            assertTrue(mean(first) > 0.05);
        }
    }

    private float[] at(Renderer renderer, FrameState state, Vec3 eye, double seconds) {
        state.seconds(seconds);
        renderer.draw(offscreen.view(eye, eye.plus(new Vec3(0.1, 1, -1))), state, offscreen.picture);
        offscreen.gl.requireNoError("frame");
        return renderer.readRadiance();
    }

    @ParameterizedTest
    @EnumSource(names = {"SKYPLANE", "PROCEDURAL"})
    void aPictureDependsOnNoEarlierOne(CloudTechnique technique) {
        Level level = sunny().cloud(layer(technique, PATCHES, 3, 1, new Cloud.Motion(new Vec3(9, 0, 4), 400)))
                .level();
        FrameState state = FrameState.atStart(level);
        Quality quality = EXACT.with("cloudHistory", CloudHistory.NONE);
        try (Renderer played = load(level, quality);
                Renderer cold = load(level, quality)) {
            at(played, state, Vec3.ZERO, 2);
            at(played, state, new Vec3(300, 0, 0), 3.5);
            assertArrayEquals(at(cold, state, Vec3.ZERO, 11.25), at(played, state, Vec3.ZERO, 11.25));
        }
    }
}
