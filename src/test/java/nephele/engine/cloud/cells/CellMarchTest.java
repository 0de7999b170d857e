package nephele.engine.cloud.cells;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.cells.CellMarch.OutsideOfCloud;
import nephele.engine.cloud.field.EllipsoidField;
import nephele.engine.cloud.field.UniformField;
import nephele.engine.cloud.light.CloudLight;
import nephele.engine.cloud.light.CloudOptics;
import nephele.engine.math.Aabb;
import nephele.engine.math.GaussLegendre;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The march of clouds keeps energy, sees nothing where nothing is, and reflects what thick and thin slabs reflect. */
class CellMarchTest {
    private static final Vec3 ONE = new Vec3(1, 1, 1);
    private static final CloudLight WHITE = new CloudLight(CloudOptics.of(1, 0.85));

    private static CellStack stack(ExtinctionField field, CellBox cells, CloudLight physics, Vec3 towardsSun) {
        DensityCells density = DensityCells.of(field, cells);
        LightCells light = LightCells.of(
                List.of(density), false, physics, new LightCells.Around(towardsSun, List.of(), LightCells.DIVISOR));
        return CellStack.finite(density, light, physics);
    }

    /** Plane albedo by adding-doubling (src/test/resources, slab_truth.csv); the beam at cosine 1 and at 0.5. */
    @ParameterizedTest
    @CsvSource({
        "1, .042316, .164878",
        "2, .091018, .280185",
        "4, .190915, .416022",
        "8, .358432, .558078",
        "16, .557209, .697405",
        "32, .727808, .814021",
        "64, .846281, .894970"
    })
    void aConservativeSlabReflectsWhatItShould(double depth, double upright, double slanted) {
        double[] beam = fluxes(depth, 1);
        double most = depth < 4 ? 0.012 : 0.003;
        assertEquals(upright, beam[0], Math.min(0.01, most));
        assertTrue(beam[0] + beam[1] <= 1.001, "no light is made: " + (beam[0] + beam[1]));
        double[] low = fluxes(depth, 0.5);
        assertEquals(slanted, low[0], most);
        assertTrue(low[0] + low[1] <= 1.001, "no light is made: " + (low[0] + low[1]));
    }

    /**
     * Radiance of an even layer of depth 25 under a beam of cosine 0.53, by the cosine and the azimuth of the ray from the
     * beam's; walks of 400,000 photons with a standard error of 0.5 %.
     */
    @ParameterizedTest
    @CsvSource({
        "0.3, 0, .2797, .0266",
        "0.3, 180, .0907, .0272",
        "0.5, 0, .2119, .0336",
        "0.5, 60, .1537, .0330",
        "0.5, 180, .1008, .0341",
        "0.7, 0, .1650, .0399",
        "0.7, 180, .1043, .0409",
        "0.9, 0, .1299, .0463",
        "0.9, 180, .1069, .0469"
    })
    void aLayerHasTheRadianceOfItsDirection(double mu, double azimuthDegrees, double fromAbove, double fromBelow) {
        double wide = 1e7;
        var field = new UniformField(new Aabb(-wide, 0, -wide, wide, 100, wide), 0.25);
        var sun = new Vec3(Math.sqrt(1 - 0.53 * 0.53), 0.53, 0);
        var march = new CellMarch(
                stack(field, new CellBox(field.bounds(), 3, 256, 3), WHITE, sun),
                new OutsideOfCloud(sun, ONE, Vec3.ZERO, Vec3.ZERO));
        double level = Math.sqrt(1 - mu * mu);
        double x = level * Math.cos(Math.toRadians(azimuthDegrees));
        double z = level * Math.sin(Math.toRadians(azimuthDegrees));
        march.march(new Ray(0, 100, 0, x, -mu, z), 0, 1e9, 1 / mu, 0.5);
        assertEquals(1, march.radiance().x() / fromAbove, 0.1, "from above");
        march.march(new Ray(0, 0, 0, x, mu, z), 0, 1e9, 1 / mu, 0.5);
        assertEquals(1, march.radiance().x() / fromBelow, 0.1, "from below");
    }

    /** Returns reflected and transmitted flux, the radiance integrated over 64 Gauss directions; an upright beam's has no azimuth. */
    private static double[] fluxes(double depth, double cosine) {
        double wide = 1e7;
        var field = new UniformField(new Aabb(-wide, 0, -wide, wide, 100, wide), depth / 100);
        var sun = new Vec3(Math.sqrt(1 - cosine * cosine), cosine, 0);
        var march = new CellMarch(
                stack(field, new CellBox(field.bounds(), 3, 256, 3), WHITE, sun),
                new OutsideOfCloud(sun, ONE, Vec3.ZERO, Vec3.ZERO));
        var rule = new GaussLegendre(64);
        int azimuths = cosine == 1 ? 1 : 16;
        double[] fluxes = {0, Math.exp(-depth / cosine)};
        for (int node = 0; node < 64; node++) {
            double mu = rule.nodes[node];
            double level = Math.sqrt(1 - mu * mu);
            for (int n = 0; n < azimuths; n++) {
                double azimuth = (n + 0.5) * Math.PI / azimuths;
                double weight = 2 * Math.PI * mu * rule.weights[node] / azimuths / cosine;
                for (int side = 0; side < 2; side++) {
                    double x = level * Math.cos(azimuth);
                    double z = level * Math.sin(azimuth);
                    march.march(new Ray(0, side == 0 ? 100 : 0, 0, x, side == 0 ? -mu : mu, z), 0, 1e9, 1 / mu, 0.5);
                    fluxes[side] += weight * march.radiance().x();
                }
            }
        }
        return fluxes;
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-6, 0.01, 1, 100, 1e4})
    void inEvenLightAWhiteCloudIsInvisible(double depth) {
        var field = new EllipsoidField(new Aabb(-50, -30, -40, 50, 30, 40), depth / 60);
        var march = new CellMarch(
                stack(field, CellBox.of(field.bounds(), 24), WHITE, new Vec3(0, 1, 0)),
                new OutsideOfCloud(new Vec3(0, 1, 0), Vec3.ZERO, ONE, ONE));
        for (double stepCells : new double[] {0.3, 1, 7}) {
            for (int n = 0; n < 40; n++) {
                double angle = 0.157 * n;
                var eye = n % 4 == 0 ? new Vec3(3, 5, -7) : new Vec3(-200 * Math.cos(angle), 9, -200 * Math.sin(angle));
                march.march(Ray.of(eye, new Vec3(Math.cos(angle), 0, Math.sin(angle))), 0, 1e9, stepCells, 0.5);
                double seen = march.radiance().x() + march.transmittance();
                assertEquals(1, seen, 1e-6, "depth " + depth + ", direction " + n);
            }
        }
    }

    @Test
    void nothingIsSeenOfNoExtinction() {
        var field = new UniformField(new Aabb(-50, -30, -40, 50, 30, 40), 0);
        var march = new CellMarch(
                stack(field, CellBox.of(field.bounds(), 8), WHITE, new Vec3(0, 1, 0)),
                new OutsideOfCloud(new Vec3(0, 1, 0), ONE, ONE, ONE));
        march.march(new Ray(-100, 0, 0, 1, 0, 0), 0, 1e9, 1, 0.5);
        assertEquals(1, march.transmittance());
        assertEquals(Vec3.ZERO, march.radiance());
    }

    @Test
    void anOpaqueCloudIsFiniteAndHidesWhatIsBehind() {
        var field = new UniformField(new Aabb(-50, -30, -40, 50, 30, 40), 200);
        var sun = new Vec3(0, 1, 0);
        var march = new CellMarch(
                stack(field, CellBox.of(field.bounds(), 24), WHITE, sun), new OutsideOfCloud(sun, ONE, ONE, ONE));
        march.march(new Ray(-100, 0, 0, 1, 0, 0), 0, 1e9, 1, 0.5);
        assertEquals(0, march.transmittance());
        assertTrue(march.radiance().x() > 0 && march.radiance().x() < 2, "" + march.radiance());
    }

    @Test
    void aRayInsideALayerOfTheRoundPlanetLeavesItAtAFiniteDistance() {
        // Level with the middle of a layer of 2 km: √(2 R h) for the 1000 m up to its top.
        StackSpan span = StackSpan.betweenHeights(0.5 / 6_360_000, 0, 1000, -1000);
        assertEquals(0, span.fromMetres());
        assertEquals(Math.sqrt(2 * 6_360_000.0 * 1000), span.toMetres(), 1e-3);
    }

    @ParameterizedTest
    @ValueSource(doubles = {-1e-3, 0, 1e-3})
    void anEyeThatCrossesTheBaseSeesNoJump(double height) {
        double slope = Math.sin(Math.toRadians(20));
        StackSpan span = StackSpan.betweenHeights(0, slope, height, height - 500);
        assertEquals(0, span.fromMetres(), 2e-3 / slope);
        assertEquals(500 / slope, span.toMetres(), 2e-3 / slope);
    }
}
