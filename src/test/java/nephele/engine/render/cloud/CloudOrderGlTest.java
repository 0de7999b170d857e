package nephele.engine.render.cloud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Clouds of different techniques hide each other by their distance alone, from below and from above. */
@TestInstance(Lifecycle.PER_CLASS)
class CloudOrderGlTest {
    private static final List<CloudTechnique> TECHNIQUES = List.of(
            CloudTechnique.VOLUME,
            CloudTechnique.PARTICLES,
            CloudTechnique.BILLBOARD,
            CloudTechnique.SKYPLANE,
            CloudTechnique.PROCEDURAL,
            CloudTechnique.SKYBOX);
    private static final int SIDE = 9;

    private final Offscreen offscreen = new Offscreen(SIDE, SIDE);

    @AfterAll
    void close() {
        offscreen.close();
    }

    static Stream<Arguments> pairs() {
        return TECHNIQUES.stream().flatMap(low -> TECHNIQUES.stream().map(high -> Arguments.of(low, high)));
    }

    /** An opaque cloud at a height: black, or as bright as the white sky around it. */
    private static Cloud cloud(String id, double height, CloudTechnique technique, double albedo) {
        boolean isNoise = technique == CloudTechnique.PROCEDURAL;
        return new Cloud(
                id,
                new Cloud.Extent.Volume(new Vec3(0, height, 0), new Vec3(400, 40, 400)),
                technique,
                isNoise ? new Cloud.Density.Noise(1, 4000, 1) : new Cloud.Density.Ellipsoid(),
                2,
                albedo,
                0);
    }

    @ParameterizedTest
    @MethodSource("pairs")
    void theNearerCloudHidesTheFartherOne(CloudTechnique low, CloudTechnique high) {
        boolean isBaked = low == CloudTechnique.SKYBOX || high == CloudTechnique.SKYBOX;
        Vec3 up = new Vec3(0.05, 1, 0.02);
        Vec3 down = new Vec3(0.05, -1, 0.02);
        List<Cloud> clouds = List.of(cloud("black", 100, low, 0), cloud("white", 200, high, 1));
        try (Renderer renderer = load(white(), clouds)) {
            assertEquals(0, middle(renderer, Vec3.ZERO, up), 0.02, "from below");
            if (!isBaked) {
                assertEquals(1, middle(renderer, new Vec3(0, 300, 0), down), 0.1, "from above");
            }
        }
        if (isBaked) {
            List<Cloud> under = List.of(cloud("black", -200, low, 0), cloud("white", -100, high, 1));
            assertEquals(1, middle(white(), under, down), 0.1, "from above");
        }
    }

    private static TestLevel white() {
        return new TestLevel().sky(new Sky.Constant(new Vec3(1, 1, 1)));
    }

    /**
     * Light of a level sun in a black sky comes from each cloud as from a lamp, since none is above, below or in the shade of
     * another: the whole slanted stack shows the sum of what each shows alone, dimmed by those in front of it.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 350, 700})
    void aStackIsTheSumOfItsClouds(double eye) {
        List<CloudTechnique> stack = List.of(
                CloudTechnique.PARTICLES,
                CloudTechnique.BILLBOARD,
                CloudTechnique.SKYPLANE,
                CloudTechnique.SKYPLANE,
                CloudTechnique.VOLUME,
                CloudTechnique.PROCEDURAL,
                CloudTechnique.SKYBOX);
        List<Cloud> all = new ArrayList<>();
        for (int i = 0; i < stack.size(); i++) {
            double height = 100 + 90 * (i < 3 ? i : i + 1);
            all.add(lamp("cloud " + i, height - eye, stack.get(i), 0.3 + 0.1 * i));
        }
        for (int upwards = eye == 0 ? 1 : -1; upwards <= (eye == 700 ? -1 : 1); upwards += 2) {
            Vec3 towards = new Vec3(0.005, upwards, -upwards);
            List<Cloud> seen = new ArrayList<>();
            for (Cloud cloud : all) {
                if (upwards * height(cloud) > 0) {
                    seen.add(cloud);
                }
            }
            seen.sort(Comparator.comparingDouble(cloud -> Math.abs(height(cloud))));
            double sum = 0;
            double passed = 1;
            for (Cloud cloud : seen) {
                sum += passed * middle(night(), List.of(cloud), towards);
                passed *= middle(white(), List.of(withoutAlbedo(cloud)), towards);
            }
            assertTrue(passed < 0.5 && sum > 0.05, () -> "clouds that dim and shine");
            assertEquals(sum, middle(night(), all, towards), 0.02 * sum);
        }
    }

    private static double height(Cloud cloud) {
        return ((Cloud.Extent.Volume) cloud.extent()).centre().y();
    }

    private static TestLevel night() {
        return new TestLevel().sky(new Sky.Constant(Vec3.ZERO)).sun(new Vec3(1, 0, 0), 20);
    }

    private static Cloud lamp(String id, double height, CloudTechnique technique, double albedo) {
        Cloud high = cloud(id, height, technique, albedo);
        var slanted = new Cloud.Extent.Volume(new Vec3(0, height, -height), new Vec3(200, 40, 60));
        return new Cloud(id, slanted, technique, high.density(), 0.015, albedo, 0);
    }

    private static Cloud withoutAlbedo(Cloud cloud) {
        return new Cloud(
                cloud.id(), cloud.extent(), cloud.technique(), cloud.density(), cloud.extinctionPerMetre(), 0, 0);
    }

    /** Returns the radiance along a ray from the origin, from which skyboxes are baked. */
    private double middle(TestLevel level, List<Cloud> clouds, Vec3 towards) {
        try (Renderer renderer = load(level, clouds)) {
            return middle(renderer, Vec3.ZERO, towards);
        }
    }

    private Renderer load(TestLevel level, List<Cloud> clouds) {
        clouds.forEach(level::cloud);
        var settings = RenderSettings.of(
                Output.HDR,
                Quality.ULTRA.with("samples", 1).with("cloudLightCell", 8).with("cloudSkyboxTexels", 32));
        return LevelRenderer.load(offscreen.gl, level.level(), TestAssets.NONE, settings);
    }

    private double middle(Renderer renderer, Vec3 eye, Vec3 towards) {
        renderer.draw(offscreen.view(eye, eye.plus(towards)), offscreen.picture);
        offscreen.gl.requireNoError("frame");
        return renderer.readRadiance()[3 * (SIDE * SIDE / 2)];
    }
}
