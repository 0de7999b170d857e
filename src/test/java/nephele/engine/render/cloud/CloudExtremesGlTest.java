package nephele.engine.render.cloud;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
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
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Drawn clouds at the ends of their scales: no depth, great depth, and an eye that crosses their bounds. */
@TestInstance(Lifecycle.PER_CLASS)
class CloudExtremesGlTest {
    private static final int WIDTH = 96;
    private static final int HEIGHT = 54;
    /** Half the axes of an ellipsoid around the origin, metres. */
    private static final Vec3 BALL = new Vec3(10, 5, 7);

    private static final double BALL_PER_METRE = 0.4;
    private static final List<Quality> PRESETS = List.of(Quality.LOW, Quality.MEDIUM, Quality.HIGH, Quality.ULTRA);

    private final Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
    private final RenderTarget large =
            RenderTarget.picture(offscreen.gl, "large", PixelFormat.RGBA8, 2 * WIDTH, 2 * HEIGHT);
    private final Level heaps = heaps().level();
    /** Keeps the heaps sampled for all renderers of them. */
    private final Renderer finestHeaps = load(heaps, Quality.ULTRA);

    @AfterAll
    void close() {
        finestHeaps.close();
        large.close();
        offscreen.close();
    }

    private static TestLevel evenSky(double radiance) {
        Vec3 grey = TestLevel.grey(radiance);
        return new TestLevel().sky(new Sky.Constant(grey));
    }

    private Renderer load(Level level, Quality quality) {
        return LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, RenderSettings.of(Output.HDR, quality));
    }

    private float[] drawn(Renderer renderer, View view) {
        return drawn(renderer, view, offscreen.picture);
    }

    private float[] drawn(Renderer renderer, View view, RenderTarget picture) {
        renderer.forget();
        renderer.draw(view, picture);
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
        try (Renderer renderer = load(level, quality)) {
            for (Vec3 eye : List.of(Vec3.ZERO, new Vec3(0, 1, -30), new Vec3(0, 4.999, -30))) {
                for (float value : drawn(renderer, offscreen.view(eye, new Vec3(3, 1, -40)))) {
                    assertEquals(1, value, 1 / 255.0, () -> "from " + eye);
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
        try (Renderer bare = load(without, PRESETS.get(preset));
                Renderer clouded = load(with, PRESETS.get(preset))) {
            View view = offscreen.view(Vec3.ZERO, new Vec3(0, 0, -30));
            assertArrayEquals(drawn(bare, view), drawn(clouded, view));
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

    Stream<Arguments> looks() {
        Level balls = new TestLevel()
                .sun(new Vec3(0.4, 0.8, 0.3), 4)
                .sky(new Sky.Gradient(new Vec3(0.1, 0.3, 0.8), new Vec3(0.5, 0.6, 0.8), new Vec3(0.2, 0.2, 0.2)))
                .cloud(new Vec3(0, 30, -90), new Vec3(60, 30, 40), 0.3, 1, 0.6)
                .cloud(new Vec3(40, 25, -50), new Vec3(30, 20, 30), 0.2, 0.95, 0.85)
                .level();
        return Stream.of(
                Arguments.of("balls", balls, List.of(Vec3.ZERO)),
                Arguments.of("heaps from below and above", heaps, List.of(Vec3.ZERO, new Vec3(0, 1200, 0))));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("looks")
    void qualityChangesCostAndNotTheLight(String name, Level level, List<Vec3> eyes) {
        try (Renderer finest = load(level, Quality.ULTRA)) {
            List<Double> ultra = means(finest, eyes);
            for (Quality quality : PRESETS.subList(0, 3)) {
                try (Renderer renderer = load(level, quality)) {
                    List<Double> means = means(renderer, eyes);
                    for (int i = 0; i < means.size(); i++) {
                        assertEquals(1, means.get(i) / ultra.get(i), 0.01, eyes.get(i) + ", " + quality);
                    }
                }
            }
        }
    }

    private List<Double> means(Renderer renderer, List<Vec3> eyes) {
        List<Double> means = new ArrayList<>();
        for (Vec3 eye : eyes) {
            double rise = eye.y() > 0 ? -0.4 : 0.4;
            View view = offscreen.view(eye, eye.plus(new Vec3(0.1, rise, -1)));
            means.add(mean(drawn(renderer, view, large)));
        }
        return means;
    }

    private static double mean(float[] values) {
        double sum = 0;
        for (float value : values) {
            sum += value;
        }
        return sum / values.length;
    }

    /** A way through a bound of a cloud. @param along unit */
    private record Crossing(String name, Vec3 place, Vec3 along) {}

    Stream<Arguments> bounds() {
        TestLevel ball = evenSky(0.4).sun(new Vec3(0.4, 0.8, 0.3), 3);
        ball.cloud(Vec3.ZERO, BALL.scaled(2), BALL_PER_METRE, 1, 0.7);
        TestLevel fog = evenSky(0.4).sun(new Vec3(0.4, 0.8, 0.3), 3).layer(40, 25, 0.05, 1, 0.7);
        Vec3 up = new Vec3(0, 1, 0);
        return Stream.of(
                Arguments.of(
                        "an even layer",
                        fog.level(),
                        List.of(
                                new Crossing("base", new Vec3(0, 40, 0), up),
                                new Crossing("top", new Vec3(0, 65, 0), up))),
                Arguments.of(
                        "a ball",
                        ball.level(),
                        List.of(
                                new Crossing("bottom", new Vec3(0.1, -BALL.y(), 0.1), up),
                                new Crossing("top", new Vec3(0.1, BALL.y(), 0.1), up),
                                new Crossing("side", new Vec3(BALL.x(), 0.1, 0.1), new Vec3(1, 0, 0)))),
                Arguments.of(
                        "heaps",
                        heaps,
                        List.of(
                                new Crossing("base", new Vec3(30, 400, 20), up),
                                new Crossing("top", new Vec3(30, 700, 20), up))));
    }

    /**
     * In steps of 1 mm from 3 mm before to 3 mm behind a bound, each picture is the one before within a code, beyond what
     * an ellipsoid of that size lets less or more light pass.
     */
    @ParameterizedTest(name = "{0}")
    @MethodSource("bounds")
    void nothingPopsWhereTheEyeCrossesABound(String name, Level level, List<Crossing> crossings) {
        boolean isBall = name.equals("a ball");
        try (Renderer renderer = load(level, Quality.HIGH)) {
            for (Crossing crossing : crossings) {
                float[] before = null;
                float[] passedBefore = null;
                for (int millimetres = -3; millimetres <= 3; millimetres++) {
                    Vec3 eye = crossing.place.addScaled(1e-3 * millimetres, crossing.along);
                    View view = offscreen.view(eye, eye.plus(new Vec3(0.8, 0.1, -0.6)));
                    float[] now = drawn(renderer, view);
                    float[] passed = isBall ? passedBall(view) : new float[now.length];
                    if (before != null) {
                        double most = beyond(before, now, passedBefore, passed);
                        assertEquals(0, 255 * most, 1, crossing.name + ", codes at " + millimetres + " mm");
                    }
                    before = now;
                    passedBefore = passed;
                }
            }
        }
    }

    /** Returns the share of light that the ball lets pass in each pixel and channel. */
    private static float[] passedBall(View view) {
        float[] passed = new float[3 * WIDTH * HEIGHT];
        Vec3 from = unitBall(view.eye());
        for (int i = 0; i < passed.length; i++) {
            double x = (2 * (i / 3 % WIDTH) + 1.0) / WIDTH - 1;
            double y = (2 * (i / 3 / WIDTH) + 1.0) / HEIGHT - 1;
            Vec3 towards = view.right()
                    .scaled(x * WIDTH / HEIGHT)
                    .addScaled(y, view.up())
                    .addScaled(-1, view.back());
            Vec3 ray = unitBall(towards);
            double a = ray.dot(ray);
            double b = ray.dot(from);
            double square = b * b - a * (from.dot(from) - 1);
            double root = Math.sqrt(Math.max(0, square));
            double chord = Math.max(0, root - b) / a - Math.max(0, -root - b) / a;
            passed[i] = (float) Math.exp(-BALL_PER_METRE * chord * towards.length());
        }
        return passed;
    }

    private static Vec3 unitBall(Vec3 v) {
        return new Vec3(v.x() / BALL.x(), v.y() / BALL.y(), v.z() / BALL.z());
    }

    private static double beyond(float[] before, float[] now, float[] passedBefore, float[] passed) {
        double greatest = 0;
        for (int i = 0; i < now.length; i++) {
            double expected = Math.abs(passed[i] - passedBefore[i]);
            greatest = Math.max(greatest, Math.abs(now[i] - before[i]) - expected);
        }
        return greatest;
    }
}
