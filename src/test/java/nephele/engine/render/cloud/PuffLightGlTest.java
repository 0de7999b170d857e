package nephele.engine.render.cloud;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.cloud.field.PuffsField;
import nephele.engine.cloud.light.BeamLight;
import nephele.engine.cloud.light.CloudOptics;
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
import nephele.engine.render.frame.Quality.PuffLight;
import nephele.engine.scene.View;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** The models of sunlight in soft balls. */
@TestInstance(Lifecycle.PER_CLASS)
class PuffLightGlTest {
    private static final int WIDTH = 96;
    private static final int HEIGHT = 54;
    private static final double SUN = 4;
    private static final Vec3 TOWARDS_SUN = new Vec3(0.5, 0.6, 0.6);
    private static final Vec3 CENTRE = new Vec3(0, 10, -120);
    private static final List<Cloud.Puff> HEAP = List.of(
            new Cloud.Puff(new Vec3(-16, 0, 4), 14),
            new Cloud.Puff(new Vec3(4, -2, -10), 18),
            new Cloud.Puff(new Vec3(10, 8, 6), 12));

    private final Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
    private final View view = offscreen.view(Vec3.ZERO, CENTRE);

    @AfterAll
    void close() {
        offscreen.close();
    }

    private static Level level(List<Cloud.Puff> puffs, double perMetre, double sky, double sun) {
        var heap = new Cloud(
                "heap",
                new Cloud.Extent.Volume(CENTRE, new Vec3(80, 60, 60)),
                CloudTechnique.PARTICLES,
                new Cloud.Density.Puffs(puffs, null),
                perMetre,
                1,
                0.5);
        return new TestLevel()
                .sky(new Sky.Constant(TestLevel.grey(sky)))
                .sun(TOWARDS_SUN, sun)
                .cloud(heap)
                .level();
    }

    private float[] drawn(Level level, PuffLight light) {
        return drawn(level, light, Quality.ULTRA);
    }

    private float[] drawn(Level level, PuffLight light, Quality best) {
        Quality quality = best.with("samples", 1).with("particleLight", light);
        try (Renderer renderer =
                LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, RenderSettings.of(Output.HDR, quality))) {
            renderer.draw(view, offscreen.picture);
            offscreen.gl.requireNoError("frame");
            return renderer.readRadiance();
        }
    }

    /** Adds up the light of short steps along the ray of a pixel, with optical depths in closed form. */
    private double exact(PuffsField field, BeamLight light, int pixel) {
        Ray ray = Ray.of(view.eye(), offscreen.ray(view, pixel));
        Vec3 ahead = offscreen.ray(view, pixel);
        Vec3 sun = TOWARDS_SUN.scaled(1 / TOWARDS_SUN.length());
        double separation = ahead.minus(sun).dot(ahead.minus(sun));
        double step = 0.5;
        double sum = 0;
        for (double at = 40; at < 200; at += step) {
            Vec3 place = view.eye().addScaled(at + step / 2, ahead);
            double density = field.perMetre(place.x(), place.y(), place.z());
            if (density > 0) {
                double before = field.closedDepth(ray, 0, at).orElseThrow();
                double sunDepth = field.closedDepth(Ray.of(place, sun), 0, Double.POSITIVE_INFINITY)
                        .orElseThrow();
                sum += Math.exp(-before) * -Math.expm1(-density * step) * light.perDepth(separation, sunDepth);
            }
        }
        return SUN * sum;
    }

    @ParameterizedTest
    @CsvSource({"DOBASHI, 0.01", "DOBASHI, 0.06", "HARRIS, 0.01", "HARRIS, 0.06"})
    void theLightIsTheIntegralAlongTheRay(PuffLight model, double perMetre) {
        var field = new PuffsField(HEAP, CENTRE, perMetre);
        BeamLight light = model.beam(CloudOptics.of(1, 0.5));
        float[] seen = drawn(level(HEAP, perMetre, 0, SUN), model, Quality.ULTRA.with("cloudLightCell", 1));
        double wanted = 0;
        double had = 0;
        for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel += 11) {
            wanted += exact(field, light, pixel);
            had += seen[3 * pixel];
        }
        assertEquals(1, had / wanted, 0.05);
    }

    @ParameterizedTest
    @EnumSource
    void splittingBallsChangesNothing(PuffLight model) {
        List<Cloud.Puff> twice = new ArrayList<>(HEAP);
        twice.addAll(HEAP);
        float[] one = drawn(level(HEAP, 0.06, 0.3, SUN), model);
        float[] two = drawn(level(twice, 0.03, 0.3, SUN), model);
        double sumOne = 0;
        double sumTwo = 0;
        for (int i = 0; i < one.length; i++) {
            sumOne += one[i];
            sumTwo += two[i];
        }
        assertEquals(1, sumTwo / sumOne, 0.01);
    }

    /** The models differ in the light of the sun only. */
    @ParameterizedTest
    @EnumSource
    void aWhiteFurnaceIsWhite(PuffLight model) {
        for (double perMetre : new double[] {0, 0.05, 500}) {
            for (float value : drawn(level(HEAP, perMetre, 1, 0), model)) {
                assertEquals(1, value, 1 / 255.0);
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    void withoutDepthNothingIsDrawnAndWithMuchAllIsFinite(PuffLight model) {
        assertArrayEquals(drawn(level(HEAP, 0, 0.7, SUN), PuffLight.TAIL), drawn(level(HEAP, 0, 0.7, SUN), model));
        for (float value : drawn(level(HEAP, 500, 0.3, SUN), model)) {
            assertTrue(Float.isFinite(value) && value >= 0, "value " + value);
        }
    }

    @Test
    void forwardScatteringIsBrighterThanOneScattering() {
        float[] once = drawn(level(HEAP, 0.06, 0, SUN), PuffLight.DOBASHI);
        float[] forwards = drawn(level(HEAP, 0.06, 0, SUN), PuffLight.HARRIS);
        double sumOnce = 0;
        double sumForwards = 0;
        for (int i = 0; i < once.length; i++) {
            assertTrue(forwards[i] >= 0.999 * once[i], "pixel " + i / 3);
            sumOnce += once[i];
            sumForwards += forwards[i];
        }
        assertTrue(sumForwards > 1.005 * sumOnce, sumForwards + " and " + sumOnce);
    }
}
