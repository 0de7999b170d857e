package nephele.engine.render.cloud;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.stream.Stream;
import nephele.engine.asset.TestAssets;
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
import nephele.engine.scene.View;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Drawn clouds at the ends of their scales: no depth, great depth, and an eye that crosses their bounds. */
class CloudExtremesGlTest {
    private static final int WIDTH = 96;
    private static final int HEIGHT = 54;
    private static final List<Quality> PRESETS = List.of(Quality.LOW, Quality.MEDIUM, Quality.HIGH, Quality.ULTRA);

    private static TestLevel evenSky(double radiance) {
        Vec3 grey = TestLevel.grey(radiance);
        return new TestLevel().sky(new Sky.Constant(grey));
    }

    private static Renderer load(Offscreen offscreen, Level level, Quality quality) {
        return Renderer.load(offscreen.gl, level, TestAssets.NONE, RenderSettings.of(Output.HDR, quality));
    }

    private static float[] drawn(Offscreen offscreen, Renderer renderer, View view) {
        renderer.forget();
        renderer.draw(view, offscreen.picture);
        offscreen.gl.requireNoError("frame");
        return renderer.readRadiance();
    }

    static Stream<Arguments> furnaces() {
        return Stream.of(
                Arguments.of(Quality.LOW, 1, 0.85),
                Arguments.of(Quality.LOW, 1e4, 0.85),
                Arguments.of(Quality.MEDIUM, 1e-3, 0.85),
                Arguments.of(Quality.HIGH, 100, 0),
                Arguments.of(Quality.ULTRA, 1, 0.999),
                Arguments.of(Quality.ULTRA, 1e4, 0.85));
    }

    /** A cloud that absorbs nothing, under light that is equal from everywhere, cannot be seen. */
    @ParameterizedTest
    @MethodSource("furnaces")
    void aWhiteFurnaceIsWhite(Quality quality, double depth, double g) {
        Level level = evenSky(1)
                .cloud(new Vec3(0, 0, -30), new Vec3(20, 10, 20), depth / 20, 1, g)
                .level();
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer renderer = load(offscreen, level, quality)) {
            for (Vec3 eye : List.of(Vec3.ZERO, new Vec3(0, 1, -30), new Vec3(0, 4.999, -30))) {
                for (float value : drawn(offscreen, renderer, offscreen.view(eye, new Vec3(3, 1, -40)))) {
                    assertEquals(1, value, 1 / 255.0, "from " + eye);
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3})
    void aCloudWithoutDepthIsNotDrawn(int preset) {
        TestLevel level = evenSky(0.7).sun(new Vec3(1, 2, 1), 3).box("wall", new Vec3(0, -2, -8), new Vec3(6, 1, 6));
        level.material("wall", TestLevel.grey(0.5));
        Level without = level.level();
        Level with = level.cloud(new Vec3(0, 0, -30), new Vec3(20, 10, 20), 0, 1, 0.85)
                .level();
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer bare = load(offscreen, without, PRESETS.get(preset));
                Renderer clouded = load(offscreen, with, PRESETS.get(preset))) {
            View view = offscreen.view(Vec3.ZERO, new Vec3(0, 0, -30));
            assertArrayEquals(drawn(offscreen, bare, view), drawn(offscreen, clouded, view));
        }
    }

    private static TestLevel heaps() {
        return new TestLevel()
                .sun(new Vec3(0.5, 0.7, 0.4), 4)
                .sky(new Sky.Gradient(new Vec3(0.1, 0.3, 0.8), new Vec3(0.5, 0.6, 0.8), new Vec3(0.2, 0.2, 0.2)))
                .cloud(new Cloud(
                        "heaps",
                        new Cloud.Extent.Layer(400, 300),
                        CloudTechnique.AUTO,
                        new Cloud.Density.Noise(3, 150, 0.5, 0.5, CloudProfile.CUMULUS, null, 0),
                        0.06,
                        1,
                        0.85));
    }

    static Stream<Arguments> looks() {
        Level balls = new TestLevel()
                .sun(new Vec3(0.4, 0.8, 0.3), 4)
                .sky(new Sky.Gradient(new Vec3(0.1, 0.3, 0.8), new Vec3(0.5, 0.6, 0.8), new Vec3(0.2, 0.2, 0.2)))
                .cloud(new Vec3(0, 30, -90), new Vec3(60, 30, 40), 0.3, 1, 0.6)
                .cloud(new Vec3(40, 25, -50), new Vec3(30, 20, 30), 0.2, 0.95, 0.85)
                .level();
        return Stream.of(
                Arguments.of("balls", balls, Vec3.ZERO),
                Arguments.of("heaps from below", heaps().level(), Vec3.ZERO),
                Arguments.of("heaps from above", heaps().level(), new Vec3(0, 1200, 0)));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("looks")
    void qualityChangesCostAndNotTheLight(String name, Level level, Vec3 eye) {
        double rise = eye.y() > 0 ? -0.4 : 0.4;
        try (Offscreen offscreen = new Offscreen(2 * WIDTH, 2 * HEIGHT);
                Renderer finest = load(offscreen, level, Quality.ULTRA)) {
            View view = offscreen.view(eye, eye.plus(new Vec3(0.1, rise, -1)));
            double ultra = mean(drawn(offscreen, finest, view));
            for (Quality quality : PRESETS.subList(0, 3)) {
                try (Renderer renderer = load(offscreen, level, quality)) {
                    assertEquals(ultra, mean(drawn(offscreen, renderer, view)), 0.01 * ultra, quality.toString());
                }
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

    static Stream<Arguments> bounds() {
        TestLevel ball = evenSky(0.4).sun(new Vec3(0.4, 0.8, 0.3), 3);
        ball.cloud(new Vec3(0, 0, 0), new Vec3(20, 10, 14), 0.4, 1, 0.7);
        TestLevel fog = evenSky(0.4).sun(new Vec3(0.4, 0.8, 0.3), 3).layer(40, 25, 0.05, 1, 0.7);
        return Stream.of(
                Arguments.of("base of a layer", fog.level(), new Vec3(0, 40, 0), new Vec3(0, 1, 0)),
                Arguments.of("top of a layer", fog.level(), new Vec3(0, 65, 0), new Vec3(0, 1, 0)),
                Arguments.of("bottom of a ball", ball.level(), new Vec3(0.1, -5, 0.1), new Vec3(0, 1, 0)),
                Arguments.of("side of a ball", ball.level(), new Vec3(10, 0.1, 0.1), new Vec3(1, 0, 0)),
                Arguments.of("base of heaps", heaps().level(), new Vec3(30, 400, 20), new Vec3(0, 1, 0)),
                Arguments.of("top of heaps", heaps().level(), new Vec3(30, 700, 20), new Vec3(0, 1, 0)));
    }

    /** In steps of 1 mm from 3 mm before to 3 mm behind a bound, each picture is the one before, but for the cells in which a ball ends. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("bounds")
    void nothingPopsWhereTheEyeCrossesABound(String name, Level level, Vec3 place, Vec3 along) {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer renderer = load(offscreen, level, Quality.HIGH)) {
            float[] before = null;
            for (int millimetres = -3; millimetres <= 3; millimetres++) {
                Vec3 eye = place.addScaled(1e-3 * millimetres, along);
                float[] now = drawn(offscreen, renderer, offscreen.view(eye, eye.plus(new Vec3(0.8, 0.1, -0.6))));
                if (before != null) {
                    assertEquals(0, greatestDifference(before, now), 5 / 255.0, "at " + millimetres + " mm");
                }
                before = now;
            }
        }
    }

    private static double greatestDifference(float[] a, float[] b) {
        double greatest = 0;
        for (int i = 0; i < a.length; i++) {
            greatest = Math.max(greatest, Math.abs(a[i] - b[i]));
        }
        return greatest;
    }
}
