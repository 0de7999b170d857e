package nephele.engine.render.cloud;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.cloud.SkyboxParallax;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.measure.Flip;
import nephele.engine.measure.LinearPicture;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.View;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Clouds that are baked around one point. */
@TestInstance(Lifecycle.PER_CLASS)
class SkyboxCloudGlTest {
    private static final int WIDTH = 96;
    private static final int HEIGHT = 54;
    /** Pixels of the distance at which half the picture is as high as far: views are 90° high. */
    private static final double FOCAL_PIXELS = HEIGHT / 2.0;

    private static final Cloud.Density HEAP = new Cloud.Density.Puffs(
            List.of(
                    new Cloud.Puff(new Vec3(-160, 0, 40), 140),
                    new Cloud.Puff(new Vec3(40, -20, -100), 180),
                    new Cloud.Puff(new Vec3(120, 80, 60), 120)),
            null);
    private static final Cloud.Density EVEN = new Cloud.Density.Ellipsoid();
    private static final Quality EXACT = Quality.ULTRA.with("samples", 1);

    private final Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);

    @AfterAll
    void close() {
        offscreen.close();
    }

    private static Cloud heap(CloudTechnique technique, double perMetre, Vec3 wind) {
        return new Cloud(
                "heap",
                new Cloud.Extent.Volume(new Vec3(0, 0, -1000), new Vec3(900, 700, 600)),
                technique,
                HEAP,
                perMetre,
                1,
                0.85,
                new Cloud.Motion(wind, 0));
    }

    private static Cloud layer(double depth) {
        return new Cloud("layer", new Cloud.Extent.Layer(900, 200), CloudTechnique.SKYBOX, EVEN, depth / 200, 1, 0.85);
    }

    private static TestLevel sunny() {
        return new TestLevel()
                .sun(new Vec3(0.4, 0.8, 0.3), 3)
                .sky(new Sky.Gradient(new Vec3(0.1, 0.3, 0.8), new Vec3(0.5, 0.6, 0.8), new Vec3(0.2, 0.2, 0.2)));
    }

    private Renderer load(Level level, Quality quality) {
        return LevelRenderer.load(
                offscreen.gl,
                level,
                TestAssets.NONE,
                RenderSettings.of(Output.HDR, quality.with("cloudLightCell", 8).with("cloudSkyboxTexels", 96)));
    }

    private View from(Vec3 eye, Vec3 towards) {
        return offscreen.view(eye, eye.plus(towards));
    }

    private float[] drawn(Renderer renderer, View view, double seconds) {
        FrameState state = FrameState.atStart(renderer.scene().level());
        state.seconds(seconds);
        renderer.draw(view, state, offscreen.picture);
        offscreen.gl.requireNoError("frame");
        return renderer.readRadiance();
    }

    private float[] drawn(Level level, Quality quality, View view) {
        try (Renderer renderer = load(level, quality)) {
            return drawn(renderer, view, 0);
        }
    }

    private static double flip(float[] reference, float[] test) {
        return Flip.ofDisplayed(new LinearPicture(WIDTH, HEIGHT, reference), new LinearPicture(WIDTH, HEIGHT, test))
                .mean();
    }

    static Stream<Arguments> furnaces() {
        return Stream.of(
                Arguments.of(Quality.LOW, layer(1e4)),
                Arguments.of(EXACT, layer(1)),
                Arguments.of(Quality.HIGH, heap(CloudTechnique.SKYBOX, 0.01, Vec3.ZERO)));
    }

    /** Views along an edge and a corner of the cube see three faces at once. */
    @ParameterizedTest
    @MethodSource("furnaces")
    void aWhiteFurnaceIsWhite(Quality quality, Cloud cloud) {
        TestLevel level = new TestLevel().sky(new Sky.Constant(TestLevel.grey(1)));
        try (Renderer renderer = load(level.cloud(cloud).level(), quality)) {
            for (Vec3 towards : List.of(new Vec3(0.1, 0.4, -1), new Vec3(-1, 0.7, 1), new Vec3(1, 0.01, 0))) {
                renderer.forget();
                for (float value : drawn(renderer, from(Vec3.ZERO, towards), 0)) {
                    assertEquals(1, value, 1 / 255.0);
                }
            }
        }
    }

    @Test
    void aCloudWithoutDepthIsNotDrawn() {
        View view = from(Vec3.ZERO, new Vec3(0, 0, -1));
        Cloud gone = new Cloud(
                "gone",
                new Cloud.Extent.Volume(new Vec3(0, 500, -200), new Vec3(90, 90, 90)),
                CloudTechnique.SKYBOX,
                new Cloud.Density.Noise(1, 300, 0),
                0.1,
                1,
                0.85);
        float[] bare = drawn(sunny().level(), Quality.HIGH, view);
        assertArrayEquals(bare, drawn(sunny().cloud(gone).level(), Quality.HIGH, view));
        assertArrayEquals(
                bare,
                drawn(sunny().cloud(heap(CloudTechnique.SKYBOX, 0, Vec3.ZERO)).level(), Quality.HIGH, view));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.01, 1e2})
    void fromTheBakePointItIsTheVolume(double perMetre) {
        View view = from(Vec3.ZERO, new Vec3(0.1, 0.1, -1));
        float[] volume = drawn(
                sunny().cloud(heap(CloudTechnique.VOLUME, perMetre, Vec3.ZERO)).level(), EXACT, view);
        float[] skybox = drawn(
                sunny().cloud(heap(CloudTechnique.SKYBOX, perMetre, Vec3.ZERO)).level(), EXACT, view);
        for (float value : skybox) {
            assertTrue(value >= 0 && value < 100);
        }
        double error = flip(volume, skybox);
        assertEquals(0, error, 0.02);
    }

    /** The eye is between puffs on all sides, which are on all faces, their edges and corners. */
    @Test
    void allFacesShowTheVolume() {
        List<Cloud.Puff> puffs = List.of(
                new Cloud.Puff(new Vec3(600, 50, -80), 200),
                new Cloud.Puff(new Vec3(-600, 500, 80), 160),
                new Cloud.Puff(new Vec3(120, 600, 60), 120),
                new Cloud.Puff(new Vec3(100, -600, -160), 180),
                new Cloud.Puff(new Vec3(-90, 150, 600), 140),
                new Cloud.Puff(new Vec3(400, 400, -400), 100));
        var around = new Cloud.Extent.Volume(Vec3.ZERO, new Vec3(1800, 1800, 1800));
        var density = new Cloud.Density.Puffs(puffs, null);
        Cloud cloud = new Cloud("around", around, CloudTechnique.VOLUME, density, 0.01, 1, 0.5);
        try (Renderer volume = load(sunny().cloud(cloud).level(), EXACT);
                Renderer skybox =
                        load(sunny().cloud(cloud.with(CloudTechnique.SKYBOX)).level(), EXACT)) {
            for (Vec3 towards : List.of(
                    new Vec3(1, 0.7, -1), new Vec3(-1, 0.5, 1), new Vec3(0.2, -1, -0.1), new Vec3(0.1, 1, 0.2))) {
                View view = from(Vec3.ZERO, towards);
                assertEquals(0, flip(drawn(volume, view, 0), drawn(skybox, view, 0)), 0.02, () -> "along " + towards);
            }
        }
    }

    /** The true cloud moves in the picture of an eye that moves by as many pixels as are told, and the baked one does not. */
    @Test
    void theParallaxIsAsTold() {
        double metres = 300;
        Vec3 side = new Vec3(metres, 0, 0);
        Cloud ball = new Cloud(
                "ball",
                new Cloud.Extent.Volume(new Vec3(0, 0, -1000), new Vec3(240, 240, 80)),
                CloudTechnique.SKYBOX,
                EVEN,
                1,
                0,
                0);
        Cloud marched = new Cloud("ball", ball.extent(), CloudTechnique.VOLUME, EVEN, 1, 0, 0);
        Vec3 ahead = new Vec3(0, 0, -1);
        TestLevel white = new TestLevel().sky(new Sky.Constant(TestLevel.grey(1)));
        double baked = middle(drawn(white.cloud(ball).level(), EXACT, from(side, ahead)));
        double truth = middle(drawn(
                new TestLevel()
                        .sky(new Sky.Constant(TestLevel.grey(1)))
                        .cloud(marched)
                        .level(),
                EXACT,
                from(side, ahead)));
        double told = new SkyboxParallax(metres, 960).pixels(FOCAL_PIXELS);
        assertEquals(WIDTH / 2.0, baked, 0.05);
        assertEquals(told, baked - truth, 0.1 * told);
    }

    /** Returns the mean column of what is darker than white. */
    private static double middle(float[] radiance) {
        double sum = 0;
        double weight = 0;
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            sum += (1 - radiance[3 * i]) * (i % WIDTH + 0.5);
            weight += 1 - radiance[3 * i];
        }
        return sum / weight;
    }

    @Test
    void aDriftingCloudIsBakedAgain() {
        Level level = sunny().cloud(heap(CloudTechnique.SKYBOX, 0.05, new Vec3(60, 0, 0)))
                .level();
        View view = from(Vec3.ZERO, new Vec3(0, 0, -1));
        try (Renderer played = load(level, EXACT);
                Renderer cold = load(level, EXACT)) {
            float[] first = drawn(played, view, 0);
            float[] last = first;
            for (int frame = 1; frame <= 40; frame++) {
                float[] next = drawn(played, view, frame / 8.0);
                assertEquals(0, flip(last, next), 0.02, "a step");
                last = next;
            }
            float[] now = drawn(cold, view, 5);
            assertEquals(0, flip(now, last), 0.25 * flip(first, now), "after drawing frames");
            assertArrayEquals(drawn(cold, view, 9), drawn(played, view, 9), "after a jump");
        }
    }

    /** The eye looks towards -x, and out of the other portal towards -z, 300 m from the bake point. */
    @Test
    void aPortalShowsWhatTheEyeBehindItWouldSee() {
        Level level = sunny().cloud(heap(CloudTechnique.SKYBOX, 0.01, Vec3.ZERO))
                .portal("a", "b", new Vec3(-2, 0, 0), new Vec3(1, 0, 0), 9, 6)
                .portal("b", "a", new Vec3(300, 20, -2), new Vec3(0, 0, -1), 9, 6)
                .level();
        try (Renderer renderer = load(level, EXACT)) {
            float[] behind = drawn(renderer, from(Vec3.ZERO, new Vec3(-1, 0, 0)), 0);
            float[] moved = drawn(renderer, from(new Vec3(300, 20, 0), new Vec3(0, 0, -1)), 0);
            assertArrayEquals(moved, behind, 1 / 255f);
            float[] elsewhere = drawn(renderer, from(new Vec3(300, 20, 0), new Vec3(0, 0.1, -1)), 0);
            assertTrue(flip(moved, elsewhere) > 0.05, "the picture shows nothing");
        }
    }

    /** A wall in front of the cloud hides it, one behind it does not. */
    @Test
    void surfacesHideWhatIsBehindThem() {
        assertTrue(seenWithWall(-500, EXACT) == 0);
        assertTrue(seenWithWall(-1500, EXACT) > 0.1);
        assertTrue(seenWithWall(-1500, Quality.HIGH) > 0.1);
    }

    private double seenWithWall(double z, Quality quality) {
        TestLevel level = new TestLevel().sky(new Sky.Constant(Vec3.ZERO)).material("black", Vec3.ZERO);
        level.cloud(heap(CloudTechnique.SKYBOX, 1, Vec3.ZERO)).sun(new Vec3(0, 1, 0.5), 3);
        level.box("black", new Vec3(0, 0, z), new Vec3(4000, 4000, 10));
        return drawn(level.level(), quality, from(Vec3.ZERO, new Vec3(0, 0, -1)))[3 * ((WIDTH * HEIGHT + WIDTH) / 2)];
    }
}
