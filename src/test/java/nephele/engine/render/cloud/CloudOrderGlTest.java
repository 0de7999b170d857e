package nephele.engine.render.cloud;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.stream.Stream;
import nephele.engine.asset.TestAssets;
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

/** Clouds of different techniques hide each other by their distance alone, from below and from above. */
@TestInstance(Lifecycle.PER_CLASS)
class CloudOrderGlTest {
    private static final List<CloudTechnique> TECHNIQUES = List.of(
            CloudTechnique.VOLUME,
            CloudTechnique.PARTICLES,
            CloudTechnique.BILLBOARD,
            CloudTechnique.SKYPLANE,
            CloudTechnique.PROCEDURAL);
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
        TestLevel level = new TestLevel().sky(new Sky.Constant(new Vec3(1, 1, 1)));
        level.cloud(cloud("black", 100, low, 0)).cloud(cloud("white", 200, high, 1));
        var settings = RenderSettings.of(Output.HDR, Quality.ULTRA.withSamples(1));
        try (Renderer renderer = Renderer.load(offscreen.gl, level.level(), TestAssets.NONE, settings)) {
            assertEquals(0, middle(renderer, new Vec3(0, 0, 0), 1), 0.02, "from below");
            assertEquals(1, middle(renderer, new Vec3(0, 300, 0), -1), 0.1, "from above");
        }
    }

    private float middle(Renderer renderer, Vec3 eye, double upwards) {
        renderer.draw(offscreen.view(eye, eye.plus(new Vec3(0.05, upwards, 0.02))), offscreen.picture);
        offscreen.gl.requireNoError("frame");
        return renderer.readRadiance()[3 * (SIDE * SIDE / 2)];
    }
}
