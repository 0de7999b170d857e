package nephele.engine.cloud.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.SplittableRandom;
import nephele.engine.cloud.ExactSlant;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.MajorantWalk;
import nephele.engine.cloud.OpticalDepth;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudProfile;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A layer around the planet is a flat one overhead, has a finite slant at the horizon, and keeps its bounds. */
class ShellFieldTest {
    private static final double R = ShellField.PLANET_METRES;
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    private static UniformField flat(double base, double top, double extinction) {
        return new UniformField(new Aabb(-INFINITE, base, -INFINITE, INFINITE, top, INFINITE), extinction);
    }

    private static Ray ray(double eye, double elevationDegrees) {
        double radians = Math.toRadians(elevationDegrees);
        return new Ray(0, eye, 0, Math.cos(radians) * 0.6, Math.sin(radians), Math.cos(radians) * 0.8);
    }

    @ParameterizedTest
    @CsvSource({"1.7, 90", "1.7, 30", "1.7, 3", "1.7, 0.3", "1.7, 0", "0, 0", "1400, 0.3", "1499.5, 0.3", "1499.999, 0"
    })
    void aSlantIsExactToAMicrometre(double eye, double elevation) {
        var shell = new ShellField(flat(1500, 1800, 0.02));
        double near = ExactSlant.metres(eye, Math.sin(Math.toRadians(elevation)), 1500);
        double far = ExactSlant.metres(eye, Math.sin(Math.toRadians(elevation)), 1800);
        MajorantWalk walk = shell.walk(ray(eye, elevation), 0, INFINITE);
        assertTrue(walk.next());
        assertEquals(near, walk.fromMetres(), 1e-6);
        double last = walk.toMetres();
        while (walk.next()) {
            assertEquals(last, walk.fromMetres(), 1e-6);
            last = walk.toMetres();
        }
        assertEquals(far, last, 1e-6);
        assertEquals(0.02 * (far - near), OpticalDepth.along(shell, ray(eye, elevation), 0, INFINITE), 1e-7);
    }

    @Test
    void theSlantIsContinuousAcrossTheHorizon() {
        var shell = new ShellField(flat(1500, 1800, 0.02));
        for (double eye : new double[] {10, 1499, 1500, 1501, 1650, 1800, 1801, 9000}) {
            double above = OpticalDepth.along(shell, ray(eye, 1e-7), 0, INFINITE);
            double below = OpticalDepth.along(shell, ray(eye, -1e-7), 0, INFINITE);
            // At a grazing face a path grows with the root of the angle.
            assertEquals(above, below, 0.02 * 1000, "eye at " + eye);
            assertTrue(above >= 0 && above < 0.02 * 400_000, "eye at " + eye + ": " + above);
        }
    }

    @Test
    void overheadItIsTheFlatLayer() {
        ExtinctionField flat = cloud(new Cloud.Density.Noise(5, 300, 0.6, 0.5, CloudProfile.CUMULUS, null, 0));
        var shell = new ShellField(flat);
        var random = new SplittableRandom(1);
        for (int n = 0; n < 500; n++) {
            double x = random.nextDouble(-500, 500);
            double y = random.nextDouble(1000, 1500);
            double z = random.nextDouble(-500, 500);
            double altitude = y + (x * x + z * z) / 2 / R;
            assertEquals(flat.perMetre(x, altitude, z), shell.perMetre(x, y, z), 1e-7);
        }
    }

    @Test
    void anAltitudeIsThatOverTheSphere() {
        assertEquals(17, ShellField.altitude(0, 17, 0));
        assertEquals(-R, ShellField.altitude(0, -R, 0));
        assertEquals(5, ShellField.altitude(0, -2 * R - 5, 0), 1e-8);
        assertEquals(5, ShellField.altitude(R + 5, -R, 0), 1e-8);
        assertEquals(0.785908, ShellField.altitude(3000, 0, 1000), 1e-3);
    }

    private static ExtinctionField cloud(Cloud.Density density) {
        return TestClouds.slack(new Cloud.Extent.Layer(1000, 500), density, 0.1);
    }

    private static Map<String, ExtinctionField> layers() {
        Map<String, ExtinctionField> layers = new LinkedHashMap<>();
        layers.put("uniform", flat(1000, 1500, 0.1));
        layers.put("image", cloud(new Cloud.Density.Image("a.png")));
        layers.put("noise", cloud(new Cloud.Density.Noise(6, 200, 0.6)));
        layers.put("stratus", cloud(new Cloud.Density.Noise(6, 500, 0.6, 0.2, CloudProfile.STRATUS, null, 0)));
        layers.put("cumulus", cloud(new Cloud.Density.Noise(7, 300, 0.5, 0.7, CloudProfile.CUMULUS, "m.png", 0)));
        layers.put(
                "grid",
                GridField.repeated(
                        SampleFields.randomGrid(5, 40, 5),
                        new Aabb(0, 1000, 0, 3000, 1500, 2000),
                        0.1,
                        ShellField.SLACK_METRES));
        return layers;
    }

    @Test
    void noPointExceedsItsMajorantAndNoneIsLeftOut() {
        layers().forEach((name, flat) -> {
            var shell = new ShellField(flat);
            var random = new SplittableRandom(2);
            for (int n = 0; n < 60; n++) {
                Ray ray = someRay(random);
                MajorantWalk walk = shell.walk(ray, 0, INFINITE);
                double at = 0;
                int segments = 0;
                while (walk.next() && segments++ < 300) {
                    assertTrue(walk.fromMetres() >= at - 1e-6 && walk.toMetres() > walk.fromMetres(), name);
                    requireAtMost(0, shell, ray, at, walk.fromMetres(), random, name);
                    requireAtMost(walk.perMetre(), shell, ray, walk.fromMetres(), walk.toMetres(), random, name);
                    at = walk.toMetres();
                }
            }
        });
    }

    private static Ray someRay(SplittableRandom random) {
        double eye = random.nextDouble(-200, 3000);
        double elevation = random.nextInt(3) == 0 ? random.nextDouble(-90, 90) : random.nextDouble(-2, 2);
        double distance = random.nextBoolean() ? 0 : random.nextDouble(2e5);
        Ray ray = ray(eye, elevation);
        return new Ray(distance, eye, -distance, ray.directionX(), ray.directionY(), ray.directionZ());
    }

    private static void requireAtMost(
            double bound,
            ExtinctionField field,
            Ray ray,
            double from,
            double to,
            SplittableRandom random,
            String name) {
        for (int n = 0; n < 4 && to - from > 1e-3; n++) {
            Vec3 p = ray.at(from + (to - from) * random.nextDouble(1e-3, 1 - 1e-3));
            double perMetre = field.perMetre(p.x(), p.y(), p.z());
            assertTrue(perMetre >= 0 && perMetre <= bound * (1 + 1e-9), name + ": " + perMetre + " over " + bound);
        }
    }

    @Test
    void aLayerInsideThePlanetIsNowhere() {
        var shell = new ShellField(flat(-8e6, -7e6, 1));
        assertFalse(shell.walk(ray(2, -90), 0, INFINITE).next());
        assertEquals(0, shell.perMetre(0, 0, 0));
    }
}
