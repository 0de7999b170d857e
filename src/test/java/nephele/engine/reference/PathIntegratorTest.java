package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Billboards;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Material;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.NightSky;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.reference.tile.TiledPicture;
import nephele.workshop.prove.portals.DoorwayLightProof;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Light that bounces has the mean that laws give it, and passes a pair of portals as it passes a doorway. */
class PathIntegratorTest {
    private static final double MOST_SIGMAS = 4;

    /** The mean of a picture's values and its standard error. */
    private record Mean(double value, double error) {
        static Mean of(TestLevel level, Pinhole eye, int samples, int seed) {
            return of(level, eye, LightTransport.FULL, samples, seed);
        }

        static Mean of(TestLevel level, Pinhole eye, LightTransport transport, int samples, int seed) {
            TracedLevel traced = TracedLevel.of(PlacedLevel.of(level.level(), TestAssets.NONE), ColourDecoding.SRGB);
            var settings = new TraceSettings(6, 6, samples, seed, 2, transport);
            TiledPicture picture = ReferencePicture.picture(traced, eye, settings, done -> {});
            double sum = 0;
            double variance = 0;
            float[] errors = picture.standardError();
            for (int i = 0; i < errors.length; i++) {
                sum += picture.rgb()[i];
                // The channels of a pixel have one path: their errors add up as if they were one.
                variance += 3 * errors[i] * errors[i];
            }
            return new Mean(sum / errors.length, Math.sqrt(variance) / errors.length);
        }
    }

    private static TestLevel room(TestLevel level, String material, Vec3 centre, Vec3 size) {
        double wall = 0.2;
        for (int axis = 0; axis < 3; axis++) {
            for (int side = -1; side <= 1; side += 2) {
                level.box(
                        material, centre.plus(along(axis, side * (of(size, axis) + wall) / 2)), slab(size, axis, wall));
            }
        }
        return level;
    }

    private static Vec3 slab(Vec3 size, int axis, double wall) {
        return new Vec3(
                axis == 0 ? wall : size.x() + 2 * wall,
                axis == 1 ? wall : size.y() + 2 * wall,
                axis == 2 ? wall : size.z() + 2 * wall);
    }

    private static Vec3 along(int axis, double metres) {
        return new Vec3(axis == 0 ? metres : 0, axis == 1 ? metres : 0, axis == 2 ? metres : 0);
    }

    private static double of(Vec3 v, int axis) {
        return axis == 0 ? v.x() : axis == 1 ? v.y() : v.z();
    }

    @ParameterizedTest
    @CsvSource({"0.1, 32", "0.5, 32", "0.8, 48", "0.9, 64", "0.99, 64"})
    void aClosedRoomOfOneAlbedoAndEmissionIsEvenlyBright(double albedo, int samples) {
        Material wall = new Material("wall", TestLevel.grey(albedo), null, null, null, null, TestLevel.grey(2), 1);
        TestLevel level = room(new TestLevel().skyLight().material(wall), "wall", Vec3.ZERO, new Vec3(4, 3, 5));
        Mean mean = Mean.of(level, Traced.eye(new Vec3(1, 0.5, -1), new Vec3(-1, -0.4, 2), 0.7), samples, 1);
        double wanted = 2 / (1 - albedo);
        assertEquals(wanted, mean.value, MOST_SIGMAS * mean.error + 1e-6 * wanted, mean.toString());
        assertTrue(mean.error < 0.05 * wanted, mean.toString());
    }

    /** Each path has the same number of bounces whether its source is found by a ray towards it or met by the path. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void theSkyIsReflectedAsOftenAsARoofThatShines(int bounces) {
        Pinhole eye = Traced.eye(new Vec3(1, 0.8, -1), new Vec3(-1, -1.5, 1), 0.6);
        Vec3 light = new Vec3(1, 2, 3);
        Material glow = new Material("glow", Vec3.ZERO, null, null, null, null, light, 1);
        TestLevel under = tub(new TestLevel().skyLight().sky(new Sky.Constant(light)));
        TestLevel below = tub(new TestLevel().skyLight().material(glow))
                .box("glow", new Vec3(0, 1.8, 0), new Vec3(4.4, 0.2, 4.6));
        var transport = new LightTransport(bounces, true);
        Mean sky = Mean.of(under, eye, transport, 256, 1);
        Mean roof = Mean.of(below, eye, transport, 256, 2);
        double error = Math.hypot(sky.error, roof.error);
        assertEquals(sky.value, roof.value, MOST_SIGMAS * error, sky + " and " + roof);
        assertTrue(error < 0.02 * sky.value, sky + " and " + roof);
    }

    /** A surface in the sun's light off a mirror has the sun's irradiance there once, times the mirror's colour. */
    @Test
    void aMirrorLightsWithTheSunOnce() {
        Vec3 tint = new Vec3(0.9, 0.6, 0.3);
        double albedo = 1e-3;
        TestLevel level = new TestLevel()
                .skyLight()
                .castingSun(new Vec3(1, 2, 0), 5)
                .material(new Material("mirror", tint, null, null, null, null, Vec3.ZERO, 1, true))
                .material("wall", TestLevel.grey(albedo))
                .box("mirror", new Vec3(0, -0.1, 0), new Vec3(2, 0.2, 2))
                .box("wall", new Vec3(-1.1, 1.5, 0), new Vec3(0.2, 3, 2));
        Pinhole eye = Traced.eye(new Vec3(3, 1, 0), new Vec3(-1, 1.2, 0), 0.01);
        Mean mean = Mean.of(level, eye, 32, 1);
        double once = albedo / Math.PI * 5 / Math.sqrt(5);
        double wanted = once * (1 + (tint.x() + tint.y() + tint.z()) / 3);
        assertEquals(wanted, mean.value, 2e-3 * wanted, mean.toString());
    }

    /** A billboard in an even sky reflects its colour's share of it, as it does in direct light, and its hole shows it. */
    @ParameterizedTest
    @EnumSource(names = {"SPHERICAL", "CYLINDRICAL"})
    void aLeafIsLitByAllOfTheSky(Billboards.Facing facing) {
        TestAssets ring = new TestAssets()
                .seeThroughPicture("ring.png", 64, 64, (x, y) -> Math.hypot(x - 31.5, y - 31.5) < 6 ? 0 : 0xffffffff);
        Level level = new TestLevel()
                .skyLight()
                .sky(new Sky.Constant(TestLevel.grey(2)))
                .billboards(Billboards.at("b", "ring.png", facing, 2, 2, List.of(new Vec3(0, -1, 0)))
                        .withEdges(TestLevel.grey(0.4)))
                .level();
        TracedLevel traced = TracedLevel.of(PlacedLevel.of(level, ring), ColourDecoding.SRGB);
        for (double x : new double[] {0, 0.4}) {
            Pinhole eye = Traced.eye(new Vec3(x, 0, 4), new Vec3(x, 0, 0), 1e-6);
            var settings = new TraceSettings(1, 1, 64, 1, 1, LightTransport.FULL);
            float[] seen = ReferencePicture.trace(traced, eye, settings, done -> {});
            assertEquals(x == 0 ? 2 : 0.8, seen[0], 1e-6, x + " m from the middle");
        }
    }

    /** Eyes see the stars that the game draws. */
    @Test
    void starsShineAtNight() {
        Sky.Atmosphere sky = new Sky.Atmosphere(0.3, 1, 0.8, 1, 45, 172, 12, 0, 0.2666);
        TestLevel level = new TestLevel().sky(sky).castingSun(new Vec3(1, -0.4, 0), 1e5);
        NightSky night = NightSky.of(sky, level.level().environment().sun(), 0).orElseThrow();
        Random random = new Random(2);
        Vec3 brightest = Vec3.ZERO;
        for (int i = 0; i < 20_000; i++) {
            Vec3 towards =
                    Directions.unit(random.nextGaussian(), Math.abs(random.nextGaussian()), random.nextGaussian());
            brightest = night.stars(towards, 0).y() > night.stars(brightest, 0).y() ? towards : brightest;
        }
        Pinhole eye = Traced.eye(Vec3.ZERO, brightest, 1e-7);
        float[] seen = Traced.picture(level, eye, new TraceSettings(1, 1, 1, 1, 1, LightTransport.FULL));
        float[] direct = Traced.picture(level, eye, new TraceSettings(1, 1, 1, 1, 1));
        double star = night.stars(brightest, 2e-7).y();
        assertEquals(star, seen[1] - direct[1], 1e-4 * star);
    }

    /** A lamp between two mirrors at right angles has three images, one of them through both in either order. */
    @Test
    void aLampInACornerOfMirrorsHasThreeImages() {
        double albedo = 1e-3;
        TestLevel level = new TestLevel()
                .skyLight()
                .material(new Material("mirror", TestLevel.grey(1), null, null, null, null, Vec3.ZERO, 1, true))
                .material("wall", TestLevel.grey(albedo))
                .light(new Light.Point("lamp", new Vec3(0.5, 1, 0.7), TestLevel.grey(3), 100, true))
                .box("wall", new Vec3(2, -0.1, 2), new Vec3(4, 0.2, 4))
                .box("mirror", new Vec3(-0.1, 1.5, 2), new Vec3(0.2, 3, 4))
                .box("mirror", new Vec3(2, 1.5, -0.1), new Vec3(4, 3, 0.2));
        Vec3 place = new Vec3(0.6, 0, 0.4);
        double wanted = 0;
        for (Vec3 image : List.of(
                new Vec3(0.5, 1, 0.7), new Vec3(-0.5, 1, 0.7), new Vec3(0.5, 1, -0.7), new Vec3(-0.5, 1, -0.7))) {
            double metres = image.minus(place).length();
            wanted += albedo / Math.PI * 3 / (metres * metres * metres);
        }
        Mean mean = Mean.of(level, Traced.eye(new Vec3(2, 2, 2), place, 1e-4), 64, 1);
        assertEquals(wanted, mean.value, MOST_SIGMAS * mean.error + 2e-3 * wanted, mean.toString());
        assertTrue(mean.error < 0.01 * wanted, mean.toString());
    }

    /** A quarter of a room between two mirrors is as bright as the whole room. */
    @Test
    void mirrorsLightAsTheRoomsInThemDo() {
        TestLevel whole = symmetric(new TestLevel());
        for (int x = -1; x <= 1; x += 2) {
            for (int z = -1; z <= 1; z += 2) {
                quarter(whole, x, z);
            }
        }
        Vec3 white = TestLevel.grey(1);
        TestLevel half = symmetric(new TestLevel())
                .material(new Material("mirror", white, null, null, null, null, Vec3.ZERO, 1, true))
                .box("mirror", new Vec3(-0.1, 0, 1), new Vec3(0.2, 3, 2))
                .box("mirror", new Vec3(1, 0, -0.1), new Vec3(2, 3, 0.2));
        quarter(half, 1, 1);
        Pinhole eye = Traced.eye(new Vec3(0.5, 0.8, 0.4), new Vec3(2, -1.2, 1.6), 0.7);
        Mean open = Mean.of(whole, eye, 96, 1);
        Mean mirrored = Mean.of(half, eye, 96, 2);
        double error = Math.hypot(open.error, mirrored.error);
        assertEquals(open.value, mirrored.value, MOST_SIGMAS * error, open + " and " + mirrored);
        assertTrue(error < 0.04 * open.value, open + " and " + mirrored);
    }

    private static TestLevel symmetric(TestLevel level) {
        Material glow = new Material("glow", TestLevel.grey(0.2), null, null, null, null, new Vec3(6, 3, 1), 1);
        return level.skyLight()
                .sky(new Sky.Constant(new Vec3(0.4, 0.6, 1)))
                .castingSun(new Vec3(0, 1, 0), 3)
                .material("wall", new Vec3(0.8, 0.7, 0.5))
                .material(glow);
    }

    /** Adds a quarter of a room around the origin with a hole in its roof. */
    private static void quarter(TestLevel level, int x, int z) {
        level.box("wall", new Vec3(x, -1.6, z), new Vec3(2, 0.2, 2))
                .box("wall", new Vec3(2.1 * x, 0, 1.1 * z), new Vec3(0.2, 3.4, 2.2))
                .box("wall", new Vec3(x, 0, 2.1 * z), new Vec3(2, 3.4, 0.2))
                .box("wall", new Vec3(1.3 * x, 1.6, z), new Vec3(1.4, 0.2, 2))
                .box("wall", new Vec3(0.3 * x, 1.6, 1.3 * z), new Vec3(0.6, 0.2, 1.4))
                .box("glow", new Vec3(1.5 * x, -1.2, 0.8 * z), TestLevel.grey(0.3))
                .light(new Light.Point("lamp" + x + z, new Vec3(x, 0.5, 1.2 * z), TestLevel.grey(2), 100, true));
    }

    /** A white room without a ceiling. */
    private static TestLevel tub(TestLevel level) {
        level.material("wall", TestLevel.grey(0.9));
        walls(level, new Vec3(0, 0, -2), 1);
        return level.box("wall", new Vec3(0, 0, -2.1), new Vec3(4.4, 3.4, 0.2));
    }

    /** {@code prove doorway-light} traces twenty rooms. */
    @ParameterizedTest
    @ValueSource(longs = {0, 1})
    void aPairOfPortalsLightsAsADoorwayDoes(long room) {
        ProofResult result = new DoorwayLightProof(6, 6, 640).run(room, 1, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertTrue(result.value("greatest standard error of a mean") < 7, result.toString());
    }

    /** Adds the floor and three walls of a room without a roof that begins at z = 0. */
    private static void walls(TestLevel level, Vec3 offset, int side) {
        level.box("wall", offset.plus(new Vec3(0, -1.6, 2.1 * side)), new Vec3(4.4, 0.2, 4.2))
                .box("wall", offset.plus(new Vec3(0, 0, 4.1 * side)), new Vec3(4.4, 3.4, 0.2))
                .box("wall", offset.plus(new Vec3(2.1, 0, 2.1 * side)), new Vec3(0.2, 3.4, 4.2))
                .box("wall", offset.plus(new Vec3(-2.1, 0, 2.1 * side)), new Vec3(0.2, 3.4, 4.2));
    }
}
