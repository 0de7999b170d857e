package nephele.engine.reference.volume;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.HenyeyGreenstein;
import nephele.engine.cloud.OpticalDepth;
import nephele.engine.cloud.field.CloudMedium;
import nephele.engine.cloud.field.SampleFields;
import nephele.engine.cloud.field.UniformField;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Free flights and ratio-tracked transmittances obey Beer and Lambert; single scattering obeys its closed form. */
@Execution(ExecutionMode.CONCURRENT)
class TrackingTest {
    private static final double INFINITE = Double.POSITIVE_INFINITY;
    private static final Aabb LAYER = new Aabb(-INFINITE, 0, -INFINITE, INFINITE, 1, INFINITE);

    private static Ray down(double mu) {
        return new Ray(0, 1, 0, Math.sqrt(1 - mu * mu), -mu, 0);
    }

    @Test
    void transmittanceOfASlabIsBeersAndLamberts() {
        for (double depth : new double[] {0.01, 0.5, 3, 8}) {
            for (double mu : new double[] {1, 0.5}) {
                var slab = new UniformField(LAYER, depth);
                double expected = Math.exp(-depth / mu);
                assertEquals(expected, Math.exp(-OpticalDepth.along(slab, down(mu), 0, INFINITE)), 1e-14);
                if (expected > 1e-4) {
                    Mean.of(200_000, 1, random -> escapes(slab, down(mu), random))
                            .requireNear(expected, 0.15, "slab");
                }
            }
        }
    }

    private static double escapes(ExtinctionField field, Ray ray, SplittableRandom random) {
        return MajorantTracking.collision(field, ray, 0, INFINITE, random) == INFINITE ? 1 : 0;
    }

    @Test
    void everyFieldTransmitsWhatItsOpticalDepthSays() {
        SampleFields.all().forEach((name, field) -> {
            var rays = new SplittableRandom(8);
            for (int n = 0; n < 6; n++) {
                Ray ray = SampleFields.ray(rays);
                double expected = Math.exp(-OpticalDepth.quadrature(field, ray, 10, 90, 64));
                Mean.of(10_000, n, random -> MajorantTracking.transmittance(field, ray, 10, 90, random))
                        .requireNear(expected, 0.3, name + ", ratio");
                Mean.of(10_000, n, random -> MajorantTracking.collision(field, ray, 10, 90, random) == INFINITE ? 1 : 0)
                        .requireNear(expected, 0.3, name + ", delta");
            }
        });
    }

    @Test
    void flightsAreExponential() {
        var slab = new UniformField(LAYER, 2);
        for (double metres : new double[] {0.1, 0.5, 0.9}) {
            Mean.of(
                            100_000,
                            2,
                            random -> MajorantTracking.collision(slab, down(1), 0, INFINITE, random) < metres ? 1 : 0)
                    .requireNear(1 - Math.exp(-2 * metres), 0.01, "flights");
        }
    }

    @Test
    void overlappingMediaCollideAtTheSumOfTheirRates() {
        var thin = new CloudMedium(new UniformField(LAYER, 0.5), 1, new HenyeyGreenstein(0));
        var dense = new CloudMedium(new UniformField(LAYER, 1.5), 1, new HenyeyGreenstein(0));
        var media = new CloudMedia(List.of(thin, dense));
        Mean.of(100_000, 3, random -> media.collision(down(1), 0, INFINITE, random) == null ? 1 : 0)
                .requireNear(Math.exp(-2), 0.02, "both");
        Mean.of(100_000, 3, random -> meets(media, thin, random)).requireNear(0.25 * (1 - Math.exp(-2)), 0.02, "thin");
        Mean.of(100_000, 3, random -> media.transmittance(down(1), 0, INFINITE, random))
                .requireNear(Math.exp(-2), 0.02, "transmittance");
    }

    private static double meets(CloudMedia media, CloudMedium medium, SplittableRandom random) {
        var met = media.collision(down(1), 0, INFINITE, random);
        return met != null && met.medium() == medium ? 1 : 0;
    }

    /** Light from a beam at mu0, scattered once in an isotropic slab of optical depth 1 to an eye at mu. */
    @Test
    void singleScatteringHasItsClosedForm() {
        once(1, 1, 0.0344039159);
        once(0.5, 1, 0.0504103617);
        once(1, 0.5, 0.02520518);
        once(-0.5, 1, 0.0370105522);
        once(-1, 1, 0.0292749158);
    }

    /** @param mu of the scattered light, negative below the slab */
    private static void once(double mu, double mu0, double expected) {
        var slab = new UniformField(LAYER, 1);
        double sine = Math.sqrt(1 - mu * mu);
        Ray eye = mu > 0 ? new Ray(0, 1, 0, sine, -mu, 0) : new Ray(0, 0, 0, sine, -mu, 0);
        double sunSine = Math.sqrt(1 - mu0 * mu0);
        Mean.of(200_000, 4, random -> {
                    double at = MajorantTracking.collision(slab, eye, 0, INFINITE, random);
                    if (at == INFINITE) {
                        return 0;
                    }
                    Vec3 p = eye.at(at);
                    var toSun = new Ray(p.x(), p.y(), p.z(), sunSine, mu0, 0);
                    double scattered = new HenyeyGreenstein(0).perSteradian(2);
                    return scattered * MajorantTracking.transmittance(slab, toSun, 0, INFINITE, random);
                })
                .requireNear(expected, 0.01, "from " + mu0 + " to " + mu);
    }

    @Test
    void anInfinitelyDenseRayEndsAtOnce() {
        var dense = new UniformField(LAYER, 1e12);
        double metres = MajorantTracking.collision(dense, down(1), 0, INFINITE, new SplittableRandom(1));
        assertTrue(metres < 1e-9, "" + metres);
        assertEquals(0, MajorantTracking.transmittance(dense, down(1), 0, INFINITE, new SplittableRandom(1)));
    }
}
