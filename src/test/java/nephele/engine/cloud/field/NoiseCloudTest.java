package nephele.engine.cloud.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.asset.VoxelGrid;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.MajorantWalk;
import nephele.engine.level.Cloud;
import nephele.engine.level.Cloud.Density.Noise;
import nephele.engine.level.CloudProfile;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Noise has the cover, the shape by height and the period that docs/clouds.md states. */
class NoiseCloudTest {
    private static final double FEATURE = 300;

    private static ExtinctionField layer(Noise noise, double thickness) {
        return field(new Cloud.Extent.Layer(1000, thickness), noise);
    }

    private static ExtinctionField field(Cloud.Extent extent, Noise noise) {
        return TestClouds.field(extent, noise, 0.05);
    }

    /** Returns the share of columns with an optical depth of at least 0.7, a transmittance of a half. */
    private static double cover(ExtinctionField field, double thickness) {
        var random = new SplittableRandom(1);
        int covered = 0;
        int columns = 600;
        int steps = 40;
        for (int n = 0; n < columns; n++) {
            double x = random.nextDouble(1000 * FEATURE);
            double z = random.nextDouble(1000 * FEATURE);
            double depth = 0;
            for (int i = 0; i < steps && depth < 0.7; i++) {
                depth += field.perMetre(x, 1000 + (i + 0.5) * thickness / steps, z) * thickness / steps;
            }
            covered += depth >= 0.7 ? 1 : 0;
        }
        return covered / (double) columns;
    }

    @ParameterizedTest
    @CsvSource({
        "STRATUS, 400, 0.2", "STRATUS, 400, 0.5", "STRATUS, 400, 0.8",
        "CUMULUS, 1000, 0.15", "CUMULUS, 1000, 0.4", "CUMULUS, 1000, 0.7",
        "CUMULONIMBUS, 6000, 0.3", "CUMULONIMBUS, 6000, 0.6"
    })
    void theCoverageIsTheShareOfTheSkyThatIsCovered(CloudProfile profile, double thickness, double coverage) {
        var noise = new Noise(2, FEATURE, coverage, 0.3, profile, null, 0);
        assertEquals(coverage, cover(layer(noise, thickness), thickness), 0.1);
    }

    @ParameterizedTest
    @EnumSource(CloudProfile.class)
    void nothingAndEverythingAreExact(CloudProfile profile) {
        assertEquals(0, cover(layer(new Noise(2, FEATURE, 0, 0, profile, null, 0), 900), 900));
        assertEquals(1, cover(layer(new Noise(2, FEATURE, 1, 0.3, profile, null, 0), 900), 900));
    }

    /** The work along a ray is bounded whatever the ratio of a cloud's edges and of its features. */
    @ParameterizedTest
    @CsvSource({"100, 1e7, 40", "100, 1e7, 1e-3", "1e7, 100, 1e-3", "1e7, 1e7, 1e-3"})
    void aRayThroughALongCloudMeetsAFewThousandCells(double across, double up, double feature) {
        Noise noise = new Noise(2, feature, 0.5, 0.3, null, null, 0);
        ExtinctionField field = field(new Cloud.Extent.Volume(Vec3.ZERO, new Vec3(across, up, 100)), noise);
        Ray along = up > across ? new Ray(1, -up, 1, 0, 1, 0) : new Ray(-across, 1, 1, 1, 0, 0);
        MajorantWalk walk = field.walk(along, 0, 2 * Math.max(across, up));
        int cells = 0;
        while (cells < 20_000 && walk.next()) {
            cells++;
        }
        assertTrue(cells <= 4098, cells + " cells");
    }

    @ParameterizedTest
    @EnumSource(CloudProfile.class)
    void thePatternRepeatsAfterTheDeclaredPeriodAndNotBefore(CloudProfile profile) {
        ExtinctionField field = layer(new Noise(5, FEATURE, 0.6, 0.5, profile, null, 0), 900);
        double period = NoiseLayouts.PERIOD_FEATURES * FEATURE;
        var random = new SplittableRandom(2);
        double half = 0;
        double shape = 0;
        for (int n = 0; n < 400; n++) {
            double x = random.nextDouble(-1e5, 1e5);
            double y = random.nextDouble(1000, 1900);
            double z = random.nextDouble(-1e5, 1e5);
            double here = field.perMetre(x, y, z);
            assertEquals(here, field.perMetre(x + period, y, z), 1e-9);
            assertEquals(here, field.perMetre(x - 2 * period, y, z + 3 * period), 1e-9);
            half += Math.abs(here - field.perMetre(x + period / 2, y, z));
            shape += Math.abs(here - field.perMetre(x + 4 * FEATURE, y, z));
        }
        assertTrue(half > 0.1 && shape > 0.1, half + " " + shape);
    }

    @Test
    void aCumulusHasAFlatBaseAndNarrowsUpwards() {
        ExtinctionField field = layer(new Noise(5, FEATURE, 0.5, 0, CloudProfile.CUMULUS, null, 0), 1000);
        double base = share(field, 1001);
        assertTrue(base > 0.3, "base " + base);
        assertEquals(base, share(field, 1100), 0.12);
        assertTrue(share(field, 1600) < 0.75 * base, "middle");
        assertTrue(share(field, 1950) < 0.15 * base, "top");
        assertEquals(0, share(field, 1999.9), 0.002);
    }

    @Test
    void anAnvilSpreadsTheTop() {
        var plain = new Noise(5, FEATURE, 0.3, 0, CloudProfile.CUMULONIMBUS, null, 0);
        var spread = new Noise(5, FEATURE, 0.3, 0, CloudProfile.CUMULONIMBUS, null, 1);
        double top = 1000 + 0.9 * 6000;
        assertTrue(share(layer(spread, 6000), top) > 2 * share(layer(plain, 6000), top));
        assertTrue(share(layer(spread, 6000), top) > 1.4 * share(layer(spread, 6000), 4000));
        assertEquals(0, share(layer(spread, 6000), 6999), 0.002);
    }

    private static double share(ExtinctionField field, double y) {
        var random = new SplittableRandom(3);
        int inside = 0;
        for (int n = 0; n < 2000; n++) {
            inside += field.perMetre(random.nextDouble(3e5), y, random.nextDouble(3e5)) > 0 ? 1 : 0;
        }
        return inside / 2000.0;
    }

    @Test
    void erosionOnlyTakesAway() {
        ExtinctionField whole = layer(new Noise(6, FEATURE, 0.5, 0, CloudProfile.CUMULUS, null, 0), 900);
        ExtinctionField eroded = layer(new Noise(6, FEATURE, 0.5, 0.8, CloudProfile.CUMULUS, null, 0), 900);
        var random = new SplittableRandom(4);
        double before = 0;
        double after = 0;
        for (int n = 0; n < 3000; n++) {
            double x = random.nextDouble(1e5);
            double y = random.nextDouble(1000, 1900);
            double z = random.nextDouble(1e5);
            double left = eroded.perMetre(x, y, z);
            assertTrue(left <= whole.perMetre(x, y, z));
            before += whole.perMetre(x, y, z);
            after += left;
        }
        assertTrue(after < 0.95 * before && after > 0.5 * before, after + " of " + before);
    }

    /** A cloud in a box has no walls: its profile ends inside of the sides, anvil included. */
    @Test
    void aProfileKeepsAwayFromTheSidesOfAVolume() {
        var box = new Cloud.Extent.Volume(new Vec3(0, 3000, 0), new Vec3(8000, 5000, 6000));
        for (CloudProfile profile : CloudProfile.values()) {
            ExtinctionField field = field(box, new Noise(7, 800, 1, 0, profile, null, profile.ordinal() / 2));
            var random = new SplittableRandom(5);
            double sum = 0;
            for (int n = 0; n < 3000; n++) {
                double y = random.nextDouble(500, 5500);
                assertEquals(0, field.perMetre(3999, y, random.nextDouble(-3000, 3000)));
                assertEquals(0, field.perMetre(random.nextDouble(-4000, 4000), y, -2999));
                sum += field.perMetre(random.nextDouble(-1000, 1000), y, random.nextDouble(-1000, 1000));
            }
            assertTrue(sum > 10, profile + " " + sum);
        }
    }

    @Test
    void aCoverageMapRulesThePlanOfAVolume() {
        var box = new Cloud.Extent.Volume(new Vec3(0, 500, 0), new Vec3(3700, 400, 2100));
        ExtinctionField field = field(box, new Noise(7, 60, 1, 0, null, "map.png", 0));
        VoxelGrid map = CloudFiles.greys(PictureDecoder.decode("map.png", TestPictures.COVERAGE.bytes("map.png")));
        for (int k = 0; k < 21; k++) {
            for (int i = 0; i < 37; i++) {
                double x = -1850 + (i + 0.5) * 100;
                double z = -1050 + (k + 0.5) * 100;
                double density = field.perMetre(x, 480, z) / 0.05;
                assertTrue(density <= map.value(i, 0, k) + 1e-9);
                assertEquals(map.value(i, 0, k) == 0, density == 0, i + ", " + k);
            }
        }
    }

    @Test
    void aMovedBoxTakesItsCloudAlong() {
        var noise = new Noise(7, 80, 0.6, 0.4, CloudProfile.CUMULUS, null, 0);
        ExtinctionField here = field(new Cloud.Extent.Volume(new Vec3(0, 500, 0), new Vec3(900, 400, 700)), noise);
        ExtinctionField there =
                field(new Cloud.Extent.Volume(new Vec3(1e6, 1500, -1e6), new Vec3(900, 400, 700)), noise);
        var random = new SplittableRandom(6);
        for (int n = 0; n < 500; n++) {
            double x = random.nextDouble(-450, 450);
            double y = random.nextDouble(300, 700);
            double z = random.nextDouble(-350, 350);
            assertEquals(here.perMetre(x, y, z), there.perMetre(x + 1e6, y + 1000, z - 1e6), 1e-8);
        }
    }

    @Test
    void aSeedGivesAnotherCloud() {
        var one = layer(new Noise(1, FEATURE, 0.9), 900);
        var two = layer(new Noise(2, FEATURE, 0.9), 900);
        double change = 0;
        for (int n = 0; n < 100; n++) {
            change += Math.abs(one.perMetre(40 * n, 1400, 20) - two.perMetre(40 * n, 1400, 20));
        }
        assertTrue(change > 0.1, "change " + change);
    }
}
