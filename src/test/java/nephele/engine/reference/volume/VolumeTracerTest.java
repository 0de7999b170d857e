package nephele.engine.reference.volume;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.HenyeyGreenstein;
import nephele.engine.cloud.field.CloudMedium;
import nephele.engine.cloud.field.EllipsoidField;
import nephele.engine.cloud.field.SampleFields;
import nephele.engine.cloud.field.UniformField;
import nephele.engine.math.Aabb;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The tracer keeps energy and reciprocity, and agrees with Chandrasekhar's H function. */
@Execution(ExecutionMode.CONCURRENT)
class VolumeTracerTest {
    private static final double INFINITE = Double.POSITIVE_INFINITY;
    private static final Vec3 ONE = new Vec3(1, 1, 1);

    /** A white furnace: a medium without absorption in uniform light is invisible, from outside and inside. */
    @Test
    void aWhiteCloudInWhiteLightIsInvisible() {
        for (double g : new double[] {-0.5, 0, 0.85, 0.999}) {
            SampleFields.all().forEach((name, field) -> {
                var tracer = tracer(field, 1, g, sky(ONE));
                var random = new SplittableRandom(9);
                for (int n = 0; n < 20; n++) {
                    Vec3 radiance = tracer.radiance(SampleFields.ray(random), random);
                    assertEquals(0, radiance.minus(ONE).length(), 1e-12, name);
                }
            });
        }
    }

    /** Two media in one place scatter as one of their summed extinctions. */
    @Test
    void overlappingMediaAreOneMediumOfTheirSum() {
        var half = medium(layer(0.5), 0.9, 0);
        var light = OutsideLight.of(
                new Vec3(0.3, 1, 0), new Vec3(3, 2, 1), (height, x, y, z) -> new Vector3d(0.1, 0.2, 0.3));
        var both = new VolumeTracer(new CloudMedia(List.of(half, half)), light);
        var one = tracer(layer(1), 0.9, 0, light);
        Mean a = Mean.of(100_000, 1, random -> both.radiance(down(0.7), random).x());
        Mean b = Mean.of(100_000, 2, random -> one.radiance(down(0.7), random).x());
        assertEquals(a.value(), b.value(), 4 * Math.hypot(a.error(), b.error()));
    }

    /** Chandrasekhar 1950, "Radiative Transfer", chapter 4: I = w/4π · mu0/(mu + mu0) · H(mu) H(mu0). */
    @Test
    void aDeepIsotropicLayerReflectsByTheHFunction() {
        double[] mus = {0.1, 0.25, 0.5, 0.75, 1};
        double[][] h = {
            {0.5, 1.07236876, 1.12965309, 1.18773513, 1.22493266, 1.25125956},
            {0.8, 1.13880767, 1.26632249, 1.41326257, 1.51816927, 1.59821952},
            {0.9, 1.17214305, 1.34327083, 1.55603380, 1.71900056, 1.85009852},
            {0.95, 1.19523181, 1.40073989, 1.67178829, 1.89178494, 2.07712384},
            {0.99, 1.22487529, 1.48074261, 1.84860102, 2.17539423, 2.47279283}
        };
        for (double[] row : h) {
            double w = row[0];
            for (int eye = 0; eye < 5; eye++) {
                int sun = (eye * 2 + 1) % 5;
                double mu0 = mus[sun];
                double expected = w / (4 * Math.PI) * mu0 / (mus[eye] + mu0) * row[1 + eye] * row[1 + sun];
                reflected(layer(200), w, 0, mus[eye], mu0, 10_000)
                        .requireNear(expected, 0.03, w + ", eye " + mus[eye] + ", sun " + mu0);
            }
        }
    }

    private static Mean reflected(ExtinctionField slab, double albedo, double g, double mu, double mu0, int paths) {
        var sun = new Vec3(0, mu0, Math.sqrt(1 - mu0 * mu0));
        var tracer = tracer(slab, albedo, g, OutsideLight.of(sun, ONE, (height, x, y, z) -> new Vector3d()));
        return Mean.of(paths, 3, random -> tracer.radiance(down(mu), random).x());
    }

    @Test
    void exchangingEyeAndSunExchangesTheCosinesOnly() {
        for (double g : new double[] {0, 0.6}) {
            Mean there = reflected(layer(3), 0.95, g, 0.3, 0.9, 60_000);
            Mean back = reflected(layer(3), 0.95, g, 0.9, 0.3, 60_000);
            double error = Math.hypot(there.error() / 0.9, back.error() / 0.3);
            assertEquals(there.value() / 0.9, back.value() / 0.3, 4 * error);
            assertEquals(0, error / there.value(), 0.03);
        }
    }

    @Test
    void aRayThatMeetsNothingReceivesTheSky() {
        var tracer = tracer(new EllipsoidField(SampleFields.BOX, 1), 0.5, 0, sky(new Vec3(1, 2, 3)));
        assertEquals(new Vec3(1, 2, 3), tracer.radiance(new Ray(0, 100, 0, 1, 0, 0), new SplittableRandom(1)));
    }

    /** The same seed gives the same bits: a path depends on nothing else. */
    @Test
    void aPathFollowsFromItsSeed() {
        var light = OutsideLight.of(new Vec3(1, 1, 1), ONE, (height, x, y, z) -> new Vector3d(1));
        SampleFields.all().forEach((name, field) -> {
            var tracer = tracer(field, 0.8, 0.3, light);
            Ray ray = Ray.of(new Vec3(-100, 1, 2), Directions.unit(1, 0.01, 0));
            assertEquals(
                    tracer.radiance(ray, new SplittableRandom(5)), tracer.radiance(ray, new SplittableRandom(5)), name);
        });
    }

    private static OutsideLight sky(Vec3 radiance) {
        return OutsideLight.of((height, x, y, z) -> radiance.toVector());
    }

    private static ExtinctionField layer(double depth) {
        return new UniformField(new Aabb(-INFINITE, 0, -INFINITE, INFINITE, 1, INFINITE), depth);
    }

    private static Ray down(double mu) {
        return new Ray(0, 1, 0, Math.sqrt(1 - mu * mu), -mu, 0);
    }

    private static CloudMedium medium(ExtinctionField field, double albedo, double g) {
        return new CloudMedium(field, albedo, new HenyeyGreenstein(g));
    }

    private static VolumeTracer tracer(ExtinctionField field, double albedo, double g, OutsideLight light) {
        return new VolumeTracer(new CloudMedia(List.of(medium(field, albedo, g))), light);
    }
}
