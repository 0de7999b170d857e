package nephele.engine.render.cloud;

import static org.junit.jupiter.api.Assertions.assertEquals;

import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
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
import nephele.engine.render.frame.Quality.SkyplaneShape;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The mesh that hangs around the eye, and how far from the sheet around the planet it shows clouds. */
class CurvedMeshGlTest {
    private static final double PLANET_RADIUS = 6_360_000;
    private static final double DEPTH = 0.5;
    private static final int WIDTH = 64;
    private static final int HEIGHT = 36;

    @Test
    void theShaderMeetsTheMesh() {
        Level level = new TestLevel()
                .sky(new Sky.Constant(TestLevel.grey(1)))
                .cloud(new Cloud(
                        "layer",
                        new Cloud.Extent.Layer(950, 100),
                        CloudTechnique.SKYPLANE,
                        new Cloud.Density.Ellipsoid(),
                        DEPTH / 100,
                        0,
                        0))
                .level();
        Quality quality =
                Quality.ULTRA.with("samples", 1).with("cloudLightCell", 8).with("skyplaneShape", SkyplaneShape.CURVED);
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer renderer = LevelRenderer.load(
                        offscreen.gl, level, TestAssets.NONE, RenderSettings.of(Output.HDR, quality))) {
            var mesh = new CurvedMesh(1000);
            for (double rise : new double[] {-0.2, 0.5, 3}) {
                View view = offscreen.view(Vec3.ZERO, new Vec3(0.1, rise, -1));
                renderer.draw(view, offscreen.picture);
                float[] drawn = renderer.readRadiance();
                double squares = 0;
                for (int i = 0; i < WIDTH * HEIGHT; i++) {
                    double cosine = mesh.cosine(offscreen.ray(view, i));
                    double expected = cosine > 0 ? Math.exp(-DEPTH / cosine) : 1;
                    squares += (drawn[3 * i] - expected) * (drawn[3 * i] - expected);
                }
                assertEquals(0, Math.sqrt(squares / (WIDTH * HEIGHT)), 0.01, "along " + rise);
            }
        }
    }

    /**
     * The elevation of a place of a layer 2 km up, at a distance in its heights: so many degrees too low (32 pixels of
     * 1,920 across 60 degrees each).
     */
    @ParameterizedTest
    @CsvSource({"0.5, 1.5", "1, 3.78", "2, 11.64", "3, 18.98", "4, 25.47", "8, 44.51"})
    void theMeshShowsCloudsTooLow(double heights, double degrees) {
        double height = 2000;
        double distance = heights * height;
        double meshElevation = Math.atan2(new CurvedMesh(height).height(distance), distance);
        double shellElevation = Math.atan2(height - distance * distance / (2 * PLANET_RADIUS), distance);
        assertEquals(degrees, Math.toDegrees(shellElevation - meshElevation), 0.05);
    }
}
