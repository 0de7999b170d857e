package nephele.engine.cloud.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.asset.VoxelGrid;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.MajorantWalk;
import nephele.engine.cloud.OpticalDepth;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudProfile;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Majorants bound the extinction, walks leave out nothing, and closed forms of optical depth agree with quadrature. */
@Execution(ExecutionMode.CONCURRENT)
class ExtinctionFieldTest {
    @Test
    void noPointExceedsItsMajorantAndNoneIsLeftOut() {
        var fields = new LinkedHashMap<>(SampleFields.all());
        fields.putAll(SampleFields.noises());
        fields.forEach((name, field) -> {
            var random = new SplittableRandom(3);
            for (int n = 0; n < 300; n++) {
                Ray ray = SampleFields.ray(random);
                double from = random.nextDouble(0, 30);
                MajorantWalk walk = field.walk(ray, from, from + 200);
                double at = from;
                while (walk.next()) {
                    assertTrue(walk.fromMetres() >= at - 1e-9 && walk.toMetres() > walk.fromMetres(), name);
                    requireAtMost(0, field, ray, at, walk.fromMetres(), random, name);
                    requireAtMost(walk.perMetre(), field, ray, walk.fromMetres(), walk.toMetres(), random, name);
                    at = walk.toMetres();
                }
                requireAtMost(0, field, ray, at, from + 200, random, name);
            }
        });
    }

    private static void requireAtMost(
            double bound,
            ExtinctionField field,
            Ray ray,
            double from,
            double to,
            SplittableRandom random,
            String name) {
        for (int n = 0; n < 20 && to - from > 1e-6; n++) {
            double at = from + (to - from) * random.nextDouble(1e-6, 1 - 1e-6);
            Vec3 p = ray.at(at);
            double perMetre = field.perMetre(p.x(), p.y(), p.z());
            assertTrue(perMetre >= 0 && perMetre <= bound * (1 + 1e-9), name + ": " + perMetre + " over " + bound);
        }
    }

    @Test
    void nothingIsOutsideOfTheBounds() {
        SampleFields.all().forEach((name, field) -> {
            Aabb b = field.bounds();
            assertEquals(0, field.perMetre(0, b.minY() - 1e-9, 0), name);
            assertEquals(0, field.perMetre(0, b.maxY() + 1e-9, 0), name);
            assertEquals(0, field.perMetre(Double.NaN, 0, 0), name);
            if (b.maxX() < Double.POSITIVE_INFINITY) {
                assertEquals(0, field.perMetre(b.maxX() + 1e-9, 0, 0), name);
                assertFalse(field.walk(new Ray(b.maxX() + 1, -50, 0, 0, 1, 0), 0, 100)
                        .next());
            }
        });
    }

    @Test
    void closedFormsOfOpticalDepthAgreeWithQuadrature() {
        SampleFields.all().forEach((name, field) -> {
            var random = new SplittableRandom(4);
            for (int n = 0; n < 300; n++) {
                Ray ray = SampleFields.ray(random);
                double from = random.nextDouble(0, 120);
                double to = from + random.nextDouble(0, 200);
                double depth = OpticalDepth.quadrature(field, ray, from, to, 32);
                field.closedDepth(ray, from, to).ifPresent(closed -> assertEquals(closed, depth, 3e-6, name));
            }
        });
    }

    @Test
    void aGaussianPuffHasTheSameDepthFromEverySide() {
        double s = 4;
        var centre = new Vec3(100, 200, 300);
        var field = new PuffsField(List.of(new Cloud.Puff(Vec3.ZERO, 2 * s)), centre, 0.07);
        var random = new SplittableRandom(5);
        double[] units = {2.5066283, 1.5203469, 0.3392352};
        for (int offset = 0; offset <= 2; offset++) {
            for (int n = 0; n < 20; n++) {
                Vec3 d = nephele.engine.math.Directions.unit(SampleFields.point(random, 1));
                Vec3 side = nephele.engine.math.Directions.perpendicular(d).scaled(offset * s);
                Ray ray = Ray.of(centre.plus(side).addScaled(-60, d), d);
                double expected = 0.07 * s * units[offset];
                assertEquals(expected, OpticalDepth.along(field, ray, 0, 1000), 1e-6 * expected + 2e-6 * s * 0.07);
                assertEquals(expected, OpticalDepth.quadrature(field, ray, 0, 1000, 16), 4e-6 * s * 0.07 + 1e-6);
                assertEquals(expected / 2, OpticalDepth.along(field, ray, 0, 60), 1e-6);
            }
        }
    }

    @Test
    void twoCoincidentHalvesAreOnePuff() {
        var puff = new Cloud.Puff(new Vec3(1, 2, 3), 10);
        var one = new PuffsField(List.of(puff), Vec3.ZERO, 0.1);
        var halves = new PuffsField(List.of(puff, puff), Vec3.ZERO, 0.05);
        var random = new SplittableRandom(6);
        for (int n = 0; n < 200; n++) {
            Ray ray = SampleFields.ray(random);
            assertEquals(
                    Math.exp(-OpticalDepth.along(one, ray, 0, 200)),
                    Math.exp(-OpticalDepth.along(halves, ray, 0, 200)),
                    1e-12);
        }
    }

    @Test
    void manyOverlappingPuffsKeepTheirSum() {
        var puffs = new java.util.ArrayList<Cloud.Puff>();
        for (int i = 0; i < 1500; i++) {
            puffs.add(new Cloud.Puff(new Vec3(i * 1e-3, 0, 0), 10));
        }
        var field = new PuffsField(puffs, Vec3.ZERO, 1e-3);
        var ray = new Ray(-100, 0, 0, 1, 0, 0);
        assertEquals(1500 * 1e-3 * 5 * 2.5066283, OpticalDepth.along(field, ray, 0, 300), 1e-4);
        assertEquals(1500 * 1e-3 * 5 * 2.5066283, OpticalDepth.quadrature(field, ray, 0, 300, 4), 1e-4);
    }

    @Test
    void aFieldOfNothingIsNothing() {
        var ray = new Ray(0, 0, 0, 1, 0, 0);
        for (ExtinctionField field : List.of(
                new PuffsField(List.of(), Vec3.ZERO, 1),
                new UniformField(SampleFields.BOX, 0),
                new EllipsoidField(SampleFields.BOX, 0),
                noCoverage(null),
                noCoverage(CloudProfile.CUMULUS),
                GridField.inBox(new VoxelGrid(1, 1, 1, SampleFields.BOX, new float[1]), SampleFields.BOX, 1))) {
            assertFalse(field.walk(ray, 0, Double.POSITIVE_INFINITY).next());
            assertEquals(0, OpticalDepth.along(field, ray, 0, Double.POSITIVE_INFINITY));
            assertEquals(0, field.perMetre(0, 0, 0));
        }
    }

    private static ExtinctionField noCoverage(CloudProfile profile) {
        var noise = new Cloud.Density.Noise(1, 10, 0, 0, profile, null, 0);
        return TestClouds.field(new Cloud.Extent.Layer(-20, 40), noise, 1);
    }

    @Test
    void aGridHasItsValuesAtVoxelCentresAndIsClampedAtItsFaces() {
        var grid = SampleFields.randomGrid(3, 2, 4);
        var field = GridField.inBox(grid, new Aabb(0, 0, 0, 6, 4, 8), 0.5);
        for (int k = 0; k < 4; k++) {
            for (int j = 0; j < 2; j++) {
                for (int i = 0; i < 3; i++) {
                    double here = 0.5 * grid.value(i, j, k);
                    assertEquals(here, field.perMetre(2 * i + 1, 2 * j + 1, 2 * k + 1), 1e-12);
                    double next = 0.5 * grid.value(Math.min(i + 1, 2), j, k);
                    assertEquals((here + next) / 2, field.perMetre(2 * i + 2, 2 * j + 1, 2 * k + 1), 1e-12);
                }
            }
        }
        assertEquals(0.5 * grid.value(0, 0, 0), field.perMetre(0, 0, 0), 1e-12);
        assertEquals(0.5 * grid.value(2, 1, 3), field.perMetre(6, 4, 8), 1e-12);
        assertEquals(0, field.perMetre(-1e-9, 1, 1));
    }

    @Test
    void aRepeatedGridContinuesAcrossItsSeam() {
        var grid = SampleFields.randomGrid(3, 2, 4);
        var field = GridField.repeated(grid, new Aabb(0, 0, 0, 6, 4, 8), 0.5);
        assertEquals(0.25 * (grid.value(0, 0, 1) + grid.value(2, 0, 1)), field.perMetre(0, 1, 3), 1e-12);
        assertEquals(field.perMetre(2.5, 1.2, 3.3), field.perMetre(2.5 - 600, 1.2, 3.3 + 8e5), 1e-9);
        assertEquals(field.perMetre(1e-12, 1, 3), field.perMetre(-1e-12, 1, 3), 1e-9);
    }

    @Test
    void anErrorFunctionIsThatOfTheTables() {
        assertEquals(0, GaussianPuff.erf(0));
        assertEquals(0.5204998778130465, GaussianPuff.erf(0.5), 1e-15);
        assertEquals(-0.8427007929497149, GaussianPuff.erf(-1), 1e-15);
        assertEquals(0.9953222650189527, GaussianPuff.erf(2), 1e-15);
        assertEquals(0.9999779095030014, GaussianPuff.erf(3), 1e-15);
        assertEquals(GaussianPuff.erf(Math.nextDown(2.5)), GaussianPuff.erf(Math.nextUp(2.5)), 1e-15);
        assertEquals(1, GaussianPuff.erf(Double.POSITIVE_INFINITY));
    }
}
