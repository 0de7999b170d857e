package nephele.engine.reference.volume;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.HenyeyGreenstein;
import nephele.engine.cloud.PhaseFunction;
import nephele.engine.cloud.field.CloudMedium;
import nephele.engine.cloud.field.EllipsoidField;
import nephele.engine.cloud.field.UniformField;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Random walks at their limits: thousands of scatterings, great depths, no thickness, along every axis. */
class LongWalkTest {
    private static final double INFINITE = Double.POSITIVE_INFINITY;
    private static final OutsideLight FURNACE = OutsideLight.of((height, x, y, z) -> new Vector3d(1));

    /** Counts the scatterings of a walk. */
    private static final class Counting implements PhaseFunction {
        private final PhaseFunction phase;
        private int scatterings;

        Counting(double g) {
            phase = new HenyeyGreenstein(g);
        }

        @Override
        public double perSteradian(double separation) {
            return phase.perSteradian(separation);
        }

        @Override
        public double sampleSeparation(SplittableRandom random) {
            scatterings++;
            return phase.sampleSeparation(random);
        }
    }

    private static UniformField layer(double thickness, double depth) {
        return new UniformField(new Aabb(-INFINITE, -thickness, -INFINITE, INFINITE, 0, INFINITE), depth / thickness);
    }

    private static Ray down(double mu) {
        return new Ray(0, 0, 0, Math.sqrt(1 - mu * mu), -mu, 0);
    }

    private static VolumeTracer tracer(ExtinctionField field, double albedo, PhaseFunction phase, OutsideLight light) {
        return new VolumeTracer(new CloudMedia(List.of(new CloudMedium(field, albedo, phase))), light);
    }

    /** From the middle of a ball of radius 40 free paths, light is scattered some thousand times. */
    @Test
    void noWalkIsCutOff() {
        var phase = new Counting(0);
        var tracer = tracer(new EllipsoidField(new Aabb(-40, -40, -40, 40, 40, 40), 1), 1, phase, FURNACE);
        var random = new SplittableRandom(1);
        int longest = 0;
        for (int n = 0; n < 40; n++) {
            int before = phase.scatterings;
            assertEquals(1, tracer.radiance(new Ray(0, 0, 0, 0, 1, 0), random).x(), 1e-9);
            longest = Math.max(longest, phase.scatterings - before);
        }
        assertTrue(longest > 2000, "longest walk: " + longest);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.85})
    void aWhiteSlabOfTenThousandOpticalDepthsIsInvisibleInAFurnace(double g) {
        var phase = new Counting(g);
        var tracer = tracer(layer(100, 1e4), 1, phase, FURNACE);
        var random = new SplittableRandom(2);
        for (int n = 0; n < 60; n++) {
            assertEquals(1, tracer.radiance(down(0.6), random).x(), 1e-9);
        }
        assertTrue(phase.scatterings > 10_000, "scatterings: " + phase.scatterings);
    }

    /** What an eye misses in a furnace is absorbed: R + T + A = 1, with R and T by adding-doubling for an upright beam. */
    @ParameterizedTest
    @CsvSource({
        ".999, .85, 1, .042160, .956656",
        ".999, .85, 8, .352121, .632506",
        ".99, 0, 1, .332922, .650978",
        ".99, 0, 8, .728750, .122068",
        ".99, 0, 32, .752715, .001868"
    })
    void whatASlabNeitherReflectsNorTransmitsIsAbsorbed(double albedo, double g, double depth, double r, double t) {
        var tracer = tracer(layer(1, depth), albedo, new HenyeyGreenstein(g), FURNACE);
        Mean seen = Mean.of(6000, 3, random -> tracer.radiance(down(1), random).x());
        assertEquals(r + t, seen.value(), 4 * seen.error() + 1e-6);
        assertTrue(seen.error() < 0.1 * (1 - r - t) + 1e-3, "known well enough: " + seen.error());
        var wrong = tracer(layer(1, depth), 1, new HenyeyGreenstein(g), FURNACE);
        assertEquals(1, wrong.radiance(down(1), new SplittableRandom(3)).x(), 1e-12, "nothing else takes light away");
    }

    /** At a given optical depth, light does not know whether a layer is a kilometre thick or a micrometre. */
    @Test
    void theThicknessOfALayerDoesNotCount() {
        double expected = lit(1);
        assertTrue(expected > 0.05, "it is lit: " + expected);
        for (double thickness : new double[] {1e-6, 1e-3, 1e4}) {
            assertEquals(expected, lit(thickness), 1e-6 * expected, thickness + " m");
        }
    }

    private static double lit(double thickness) {
        var light = OutsideLight.of(
                new Vec3(0.6, 0.8, 0), new Vec3(3, 3, 3), (height, x, y, z) -> new Vector3d(0.1 + 0.1 * y));
        var tracer = tracer(layer(thickness, 0.7), 0.9, new HenyeyGreenstein(0.5), light);
        return Mean.of(500, 4, random -> tracer.radiance(down(0.3), random).x()).value();
    }

    /** A ball looks the same from each axis with the light on each axis, but for the angle between the two. */
    @Test
    void noAxisIsSpecial() {
        Mean[][] seen = new Mean[6][6];
        Mean[] ofAngle = new Mean[3];
        for (int eye = 0; eye < 6; eye++) {
            for (int sun = 0; sun < 6; sun++) {
                seen[eye][sun] = ball(axis(eye), axis(sun), 400, 10 * eye + sun);
                int angle = (int) Math.rint(1 - axis(eye).dot(axis(sun)));
                ofAngle[angle] = ofAngle[angle] == null ? ball(axis(eye), axis(sun), 6000, 99) : ofAngle[angle];
                double error = Math.hypot(seen[eye][sun].error(), ofAngle[angle].error());
                assertEquals(
                        ofAngle[angle].value(),
                        seen[eye][sun].value(),
                        4 * error,
                        "from " + axis(eye) + ", light from " + axis(sun));
            }
        }
        assertTrue(ofAngle[2].value() > 1.5 * ofAngle[0].value(), "light from behind the ball shines through it");
    }

    private static Vec3 axis(int index) {
        double sign = index % 2 == 0 ? 1 : -1;
        return new Vec3(index / 2 == 0 ? sign : 0, index / 2 == 1 ? sign : 0, index / 2 == 2 ? sign : 0);
    }

    private static Mean ball(Vec3 eye, Vec3 towardsLight, int paths, long seed) {
        var light = OutsideLight.of(towardsLight, new Vec3(9, 9, 9), (height, x, y, z) -> new Vector3d());
        var field = new EllipsoidField(new Aabb(-1, -1, -1, 1, 1, 1), 1);
        var tracer = tracer(field, 0.9, new HenyeyGreenstein(0.6), light);
        Ray ray = Ray.of(eye.scaled(10), eye.scaled(-1));
        return Mean.of(paths, seed, random -> tracer.radiance(ray, random).x());
    }
}
