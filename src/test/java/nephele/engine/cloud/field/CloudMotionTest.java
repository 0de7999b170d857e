package nephele.engine.cloud.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.level.Cloud;
import nephele.engine.level.Cloud.Density;
import nephele.engine.level.CloudProfile;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Wind moves a cloud and nothing else, evolution changes noise alone, and both are exact after days. */
@Execution(ExecutionMode.CONCURRENT)
class CloudMotionTest {
    private static final Cloud.Extent BOX = new Cloud.Extent.Volume(new Vec3(50, 1200, -70), new Vec3(900, 500, 700));
    private static final Cloud.Extent LAYER = new Cloud.Extent.Layer(1000, 500);
    private static final double DAY = 86_400;

    private static Map<String, Density> densities() {
        Map<String, Density> all = new LinkedHashMap<>();
        all.put("image", new Density.Image("map.png"));
        all.put("ellipsoid", new Density.Ellipsoid());
        all.put("puffs", new Density.Puffs(List.of(new Cloud.Puff(new Vec3(10, 20, 30), 150)), null));
        all.put("even noise", new Density.Noise(3, 130, 0.7, 0.5, null, "map.png", 0));
        all.put("cumulus", new Density.Noise(4, 130, 0.7, 0.5, CloudProfile.CUMULUS, "map.png", 0));
        return all;
    }

    private static ExtinctionField field(Cloud.Extent extent, Density density, Cloud.Motion motion, double seconds) {
        return TestClouds.field(extent, density, 0.1, motion, seconds);
    }

    private static Vec3 point(SplittableRandom random) {
        return new Vec3(random.nextDouble(-400, 500), random.nextDouble(1000, 1500), random.nextDouble(-400, 300));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 600, DAY, 30 * DAY, 365 * DAY})
    void aVolumeMovesWithTheWindAsAWhole(double seconds) {
        var wind = new Vec3(8, -0.25, 2);
        densities().forEach((name, density) -> {
            var still = field(BOX, density, Cloud.Motion.STILL, 0);
            var moved = field(BOX, density, new Cloud.Motion(wind, 0), seconds);
            requireShifted(name, still, moved, wind.scaled(seconds));
        });
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 600, DAY, 30 * DAY, 365 * DAY})
    void aLayersPatternDriftsWithoutEnd(double seconds) {
        var wind = new Vec3(30, 0, -11);
        densities().forEach((name, density) -> {
            var still = field(LAYER, density, Cloud.Motion.STILL, 0);
            var moved = field(LAYER, density, new Cloud.Motion(wind, 0), seconds);
            requireShifted(name, still, moved, wind.scaled(seconds));
        });
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 40, 40 * 365 * DAY})
    void aCloudThatSwaysGoesThereAndBackForEver(double seconds) {
        var wind = new Vec3(0, 0, 2);
        var sway = new Vec3(20, -4, 0);
        var motion = new Cloud.Motion(wind, sway, 40, 0);
        for (int eighth = 0; eighth <= 8; eighth++) {
            double at = seconds + 5 * eighth;
            double share = (1 - Math.cos(Math.PI * eighth / 4)) / 2;
            Vec3 off = motion.drift(at).minus(wind.scaled(at).addScaled(share, sway));
            assertEquals(0, off.length(), 1e-5, at + " s");
        }
        densities()
                .forEach((name, density) -> requireShifted(
                        name,
                        field(BOX, density, Cloud.Motion.STILL, 0),
                        field(BOX, density, motion, seconds + 10),
                        wind.scaled(seconds + 10).addScaled(0.5, sway)));
    }

    private static void requireShifted(String name, ExtinctionField still, ExtinctionField moved, Vec3 by) {
        var random = new SplittableRandom(1);
        double sum = 0;
        for (int n = 0; n < 300; n++) {
            Vec3 at = point(random);
            Vec3 shifted = at.plus(by);
            double expected = still.perMetre(at.x(), at.y(), at.z());
            double tolerance = name.equals("ellipsoid") ? 0 : 1e-7;
            assertEquals(expected, moved.perMetre(shifted.x(), shifted.y(), shifted.z()), tolerance, name);
            sum += expected;
        }
        assertTrue(sum > 0, name);
    }

    @Test
    void onlyNoiseEvolves() {
        densities().forEach((name, density) -> {
            var before = field(BOX, density, new Cloud.Motion(Vec3.ZERO, 60), 0);
            var after = field(BOX, density, new Cloud.Motion(Vec3.ZERO, 60), 45);
            var random = new SplittableRandom(2);
            double change = 0;
            for (int n = 0; n < 300; n++) {
                Vec3 at = point(random);
                change += Math.abs(before.perMetre(at.x(), at.y(), at.z()) - after.perMetre(at.x(), at.y(), at.z()));
            }
            assertEquals(density instanceof Density.Noise, change > 0.1, name + " " + change);
        });
    }

    /** All four noises return after 16 × 1024 evolutions; half of that is not enough for the slowest. */
    @Test
    void evolutionReturnsAfterItsPeriod() {
        var motion = new Cloud.Motion(Vec3.ZERO, 60);
        Density density = densities().get("cumulus");
        double period = 16 * 1024 * 60;
        var before = field(LAYER, density, motion, 1234.5);
        var after = field(LAYER, density, motion, 1234.5 + period);
        var between = field(LAYER, density, motion, 1234.5 + period / 2);
        var random = new SplittableRandom(3);
        double change = 0;
        for (int n = 0; n < 500; n++) {
            Vec3 at = point(random);
            double expected = before.perMetre(at.x(), at.y(), at.z());
            assertEquals(expected, after.perMetre(at.x(), at.y(), at.z()), 1e-9);
            change += Math.abs(expected - between.perMetre(at.x(), at.y(), at.z()));
        }
        assertTrue(change > 0.1, "nothing has changed");
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-300, 1, 1e9})
    void everyTimeAndRateIsFinite(double evolution) {
        for (double seconds : new double[] {0, -5, 1e-300, 1e9, 1e300}) {
            var field = field(LAYER, densities().get("cumulus"), new Cloud.Motion(Vec3.ZERO, evolution), seconds);
            double extinction = field.perMetre(10, 1100, 20);
            assertTrue(extinction >= 0 && extinction <= 0.1, evolution + " at " + seconds);
        }
    }

    @Test
    void theShapeChangesWithoutJumps() {
        Density density = densities().get("cumulus");
        var motion = new Cloud.Motion(new Vec3(5, 0, 5), 10);
        var random = new SplittableRandom(4);
        for (int n = 0; n < 100; n++) {
            Vec3 at = point(random);
            double seconds = 5 * random.nextInt(40);
            double before = field(LAYER, density, motion, seconds - 1e-6).perMetre(at.x(), at.y(), at.z());
            double after = field(LAYER, density, motion, seconds + 1e-6).perMetre(at.x(), at.y(), at.z());
            assertEquals(before, after, 1e-5);
        }
    }

    /** A layer keeps its altitude and its pattern in a wind that blows up. */
    @Test
    void aLayerDoesNotRise() {
        densities().forEach((name, density) -> {
            var still = field(LAYER, density, Cloud.Motion.STILL, 0);
            var moved = field(LAYER, density, new Cloud.Motion(new Vec3(0, 3, 0), 0), 40);
            requireShifted(name, still, moved, Vec3.ZERO);
        });
    }
}
