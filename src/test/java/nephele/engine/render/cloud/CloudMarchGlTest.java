package nephele.engine.render.cloud;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.Stream;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.cloud.cells.CellMarch;
import nephele.engine.cloud.cells.LightCells;
import nephele.engine.cloud.drawn.CloudTimeline;
import nephele.engine.cloud.drawn.DrawnCloud;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudProfile;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.View;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;

/** The shader that marches clouds is its Java twin, within a code of 255 of white. */
@TestInstance(Lifecycle.PER_CLASS)
class CloudMarchGlTest {
    private static final int WIDTH = 48;
    private static final int HEIGHT = 32;
    /** For the many boxes of layers. */
    private static final int COARSE_LIGHT = 4;

    private static final Vec3 ONE = new Vec3(1, 1, 1);
    private static final Vec3 SUN = new Vec3(0.6, 0.64, -0.48);
    private static final Vec3 EYE = new Vec3(40, 2, -70);

    private final Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);

    @AfterAll
    void close() {
        offscreen.close();
    }

    private static Cloud layer(Cloud.Density density, double extinctionPerMetre) {
        return new Cloud(
                "layer", new Cloud.Extent.Layer(900, 500), CloudTechnique.AUTO, density, extinctionPerMetre, 1, 0.85);
    }

    private static Cloud ball(Vec3 centre) {
        return new Cloud(
                "ball",
                new Cloud.Extent.Volume(centre, new Vec3(120, 60, 90)),
                CloudTechnique.AUTO,
                new Cloud.Density.Ellipsoid(),
                0.1,
                0.98,
                0.8);
    }

    @TestFactory
    Stream<DynamicTest> theShaderIsTheJavaTwin() {
        return Stream.of(
                DynamicTest.dynamicTest(
                        "a finite cloud", () -> compare(ball(new Vec3(20, 60, -190)), LightCells.DIVISOR)),
                DynamicTest.dynamicTest(
                        "an even layer", () -> compare(layer(new Cloud.Density.Ellipsoid(), 0.004), COARSE_LIGHT)),
                DynamicTest.dynamicTest(
                        "a layer of noise in cells",
                        () -> compare(layer(new Cloud.Density.Noise(3, 900, 0.6), 0.01), COARSE_LIGHT)),
                DynamicTest.dynamicTest(
                        "a layer of computed noise",
                        () -> compare(
                                layer(new Cloud.Density.Noise(3, 500, 0.5, 0, CloudProfile.STRATUS, null, 0), 0.008),
                                COARSE_LIGHT)));
    }

    /** Pixels that a cloud covers wholly, or not at all, are the same; at its edge display values are blended instead of light. */
    @Test
    void withoutALinearTargetTheCloudLooksTheSame() {
        Level level = new TestLevel()
                .sun(SUN, 3)
                .sky(new Sky.Constant(new Vec3(0.1, 0.2, 0.4)))
                .cloud(ball(new Vec3(0, 60, -190)))
                .level();
        View view = offscreen.view(new Vec3(0, 60, -110), new Vec3(0, 60, -190));
        int[] blended = offscreen.pixels(level, TestAssets.NONE, view, RenderSettings.of(Output.DIRECT));
        int[] linear = offscreen.pixels(level, TestAssets.NONE, view, RenderSettings.of(Output.HDR));
        int equal = 0;
        for (int i = 0; i < linear.length; i++) {
            equal += Math.abs(Offscreen.green(blended[i]) - Offscreen.green(linear[i])) <= 1 ? 1 : 0;
        }
        assertTrue(equal >= 0.8 * linear.length, "equal pixels: " + equal + " of " + linear.length);
    }

    private void compare(Cloud cloud, int lightDivisor) {
        Level level = new TestLevel()
                .sun(SUN, 1)
                .sky(new Sky.Gradient(ONE, ONE, ONE))
                .cloud(cloud)
                .level();
        Quality full = Quality.HIGH
                .with("cloudResolution", 1)
                .with("cloudHistory", Quality.CloudHistory.NONE)
                .with("cloudLightCell", lightDivisor);
        try (Renderer renderer =
                        LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, RenderSettings.of(Output.HDR, full));
                CloudTimeline timeline = new CloudTimeline(
                        level.environment(),
                        TestAssets.NONE,
                        Aabb.around(Vec3.ZERO, new Vec3(20, 20, 20)),
                        lightDivisor)) {
            View view = offscreen.view(EYE, EYE.plus(new Vec3(-0.2, 0.6, -1)));
            renderer.draw(view, offscreen.picture);
            offscreen.gl.requireNoError("frame");
            float[] drawn = renderer.readRadiance();
            DrawnCloud sampled =
                    timeline.at(level.environment(), 0, EYE).from().clouds().get(0);
            double irradiance = level.environment().sun().irradiance().x();
            var march = new CellMarch(
                    sampled.cells(),
                    new CellMarch.OutsideOfCloud(SUN, ONE.scaled(irradiance), ONE, ONE),
                    EYE,
                    sampled.source().isProfiled() ? sampled.source().noise(0) : null);
            double squares = 0;
            double covered = 0;
            for (int i = 0; i < WIDTH * HEIGHT; i++) {
                march.march(ray(view, i), 0, Double.POSITIVE_INFINITY, full.cloudStep(), offset(i));
                double error = march.radiance().x() + march.transmittance() - drawn[3 * i];
                squares += error * error;
                covered += 1 - march.transmittance();
            }
            double root = Math.sqrt(squares / (WIDTH * HEIGHT));
            assertTrue(covered > 0.05 * WIDTH * HEIGHT, "the view has clouds: " + covered);
            assertTrue(root <= 1.0 / 255, "root mean square error " + 255 * root + " codes");
        }
    }

    private static Ray ray(View view, int pixel) {
        double x = (2 * (pixel % WIDTH) + 1.0) / WIDTH - 1;
        double y = (2 * (pixel / WIDTH) + 1.0) / HEIGHT - 1;
        double aspect = WIDTH / (double) HEIGHT;
        Vec3 towards = view.right().scaled(x * aspect).addScaled(y, view.up()).addScaled(-1, view.back());
        double length = towards.length();
        return new Ray(
                view.eyeX(),
                view.eyeY(),
                view.eyeZ(),
                towards.x() / length,
                towards.y() / length,
                towards.z() / length);
    }

    /** Returns the offset of a pixel's first sample, in the shader's precision. */
    private static double offset(int pixel) {
        float dot = (pixel % WIDTH + 0.5f) * 0.06711056f + (pixel / WIDTH + 0.5f) * 0.00583715f;
        float spread = 52.9829189f * (dot - (float) Math.floor(dot));
        return spread - Math.floor(spread);
    }
}
