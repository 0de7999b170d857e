package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.SplittableRandom;
import nephele.engine.asset.TestAssets;
import nephele.engine.cloud.HenyeyGreenstein;
import nephele.engine.level.Light;
import nephele.engine.level.Material;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.measure.RandomMean;
import nephele.engine.reference.tile.TiledPicture;
import nephele.engine.reference.volume.Deflection;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Lamps and walls light clouds, and clouds light walls, with the means that quadrature, laws and other walks give; fog stands before the eye alone. */
@Execution(ExecutionMode.CONCURRENT)
class MediaTransportTest {
    private static final double MOST_SIGMAS = 4;

    /** The red mean of a picture and its standard error. */
    private record Seen(double mean, double error) {
        static Seen of(TestLevel level, Pinhole eye, LightTransport transport, int side, int samples, long seed) {
            TracedLevel traced = TracedLevel.of(PlacedLevel.of(level.level(), TestAssets.NONE), ColourDecoding.SRGB);
            var settings = new TraceSettings(side, side, samples, seed, 2, transport);
            TiledPicture picture = ReferencePicture.picture(traced, eye, settings, done -> {});
            double sum = 0;
            double variance = 0;
            for (int pixel = 0; pixel < side * side; pixel++) {
                sum += picture.rgb()[3 * pixel];
                variance += Math.pow(picture.standardError()[3 * pixel], 2);
            }
            return new Seen(sum / (side * side), Math.sqrt(variance) / (side * side));
        }

        static Seen of(TestLevel level, Pinhole eye, int side, int samples, long seed) {
            return of(level, eye, LightTransport.FULL, side, samples, seed);
        }

        void requireNear(double expected, double otherError, double mostRelativeError) {
            double both = Math.hypot(error, otherError);
            assertEquals(expected, mean, MOST_SIGMAS * both + 1e-9 * expected, this + ", expected " + expected);
            assertTrue(both <= mostRelativeError * expected, this + " ± " + otherError);
        }
    }

    private static Light lamp(Vec3 place, double intensity) {
        return new Light.Point("lamp", place, TestLevel.grey(intensity), 1e6, true);
    }

    /** A lamp in a ball of optical depth 2 that absorbs almost all: light is scattered once, which quadrature knows. */
    @ParameterizedTest
    @CsvSource({"0.31, 0.2, 6", "0.35, 0.2, 6", "-1, 0.5, 6", "0.5, -1.7, 6", "0.2, 0.3, 1"})
    void aLampInABallIsScatteredOnceAsByQuadrature(double x, double y, double eyeZ) {
        double extinction = 0.5;
        double albedo = 1e-4;
        double g = 0.4;
        Vec3 lamp = new Vec3(0.3, 0.2, -0.4);
        TestLevel level =
                new TestLevel().light(lamp(lamp, 1000)).cloud(Vec3.ZERO, TestLevel.grey(4), extinction, albedo, g);
        Vec3 eye = new Vec3(x, y, eyeZ);
        Vec3 along = new Vec3(0, 0, -1);
        double begin = eyeZ - Math.sqrt(4 - x * x - y * y);
        double end = eyeZ + Math.sqrt(4 - x * x - y * y);
        double from = Math.max(0, begin);
        var phase = new HenyeyGreenstein(g);
        int steps = 200_000;
        double sum = 0;
        for (int i = 0; i < steps; i++) {
            double at = from + (end - from) * (i + 0.5) / steps;
            Vec3 towards = lamp.minus(eye.addScaled(at, along));
            double distance = towards.length();
            double scattered = phase.perSteradian(Deflection.separation(along, towards.scaled(1 / distance)));
            sum += Math.exp(-extinction * (at - from + distance)) * scattered / (distance * distance);
        }
        double expected = 1000 * extinction * albedo * sum * (end - from) / steps;
        Seen.of(level, Traced.eye(eye, eye.plus(along), 1e-9), 2, 2048, 1).requireNear(expected, 0, 0.03);
    }

    /**
     * The light of a lamp in the middle of a ball of radius two free paths, in a square beside the lamp as it is seen from
     * far away: what an analogue walk of photons says that leaves the ball there.
     */
    @ParameterizedTest
    @CsvSource({"1, 0", "0.9, 0.5"})
    void aLampInABallIsScatteredOftenAsByAnalogueWalks(double albedo, double g) {
        double radius = 2;
        double far = 200;
        TestLevel level =
                new TestLevel().light(lamp(Vec3.ZERO, 1)).cloud(Vec3.ZERO, TestLevel.grey(2 * radius), 1, albedo, g);
        RandomMean leaving = RandomMean.of(100_000, 77, random -> leavesInSquare(radius, albedo, g, random) ? 1 : 0);
        double perFraction = 1 / Math.pow(0.6 * radius, 2);
        Pinhole eye = Traced.eye(new Vec3(0.6 * radius, 0, far), new Vec3(0.6 * radius, 0, 0), 0.3 * radius / far);
        Seen.of(level, eye, 16, 96, 1).requireNear(leaving.value() * perFraction, leaving.error() * perFraction, 0.05);
    }

    /** Returns true if a photon from the middle of a ball is seen in the square by an eye in its last direction. */
    private static boolean leavesInSquare(double radius, double albedo, double g, SplittableRandom random) {
        var phase = new HenyeyGreenstein(g);
        Vec3 direction = new Vec3(0, 0, 1);
        Vec3 place = direction.scaled(-Math.log(1 - random.nextDouble()));
        // A lamp's light grows no further within a centimetre.
        boolean isMissing = random.nextDouble() > place.dot(place) / PunctualLight.MIN_SQUARE_METRES;
        while (place.length() <= radius) {
            if (isMissing || random.nextDouble() >= albedo) {
                return false;
            }
            direction = Deflection.of(direction, phase.sampleSeparation(random), random);
            place = place.addScaled(-Math.log(1 - random.nextDouble()), direction);
        }
        double off = place.cross(direction).length() / radius;
        double angle = 2 * Math.PI * random.nextDouble();
        return Math.abs(off * Math.cos(angle) - 0.6) < 0.3 && Math.abs(off * Math.sin(angle)) < 0.3;
    }

    /** Clouds that absorb nothing change nothing in a room whose walls shine evenly, whether they touch the walls or not. */
    @ParameterizedTest
    @CsvSource({"0.5, 3, 32", "0.5, 12, 32", "0.9, 3, 48", "0.9, 12, 48"})
    void aWhiteCloudInAClosedRoomIsNotSeen(double albedo, double size, int samples) {
        TestLevel level = shiningRoom(albedo).cloud(Vec3.ZERO, TestLevel.grey(size), 0.7, 1, 0.6);
        Seen.of(level, Traced.eye(new Vec3(1, 0.5, -1), new Vec3(-1, -0.4, 2), 0.7), 6, samples, 1)
                .requireNear(2 / (1 - albedo), 0, 0.04);
    }

    /** A room of 4 × 3 × 5 m whose walls emit 2. */
    private static TestLevel shiningRoom(double albedo) {
        Material wall = new Material("wall", TestLevel.grey(albedo), null, null, null, null, TestLevel.grey(2), 1);
        TestLevel level = new TestLevel().skyLight().material(wall);
        for (int side = -1; side <= 1; side += 2) {
            level.box("wall", new Vec3(2.1 * side, 0, 0), new Vec3(0.2, 3.4, 5.4))
                    .box("wall", new Vec3(0, 1.6 * side, 0), new Vec3(4.4, 0.2, 5.4))
                    .box("wall", new Vec3(0, 0, 2.6 * side), new Vec3(4.4, 3.4, 0.2));
        }
        return level;
    }

    /** The fog that an eye sees dims no light between walls, as it dims none from the sun to a wall. */
    @Test
    void fogStandsBeforeTheEyeAlone() {
        TestLevel level = shiningRoom(0.5).fog(0.5, TestLevel.grey(1));
        double left = Math.exp(-0.5 * 2.5);
        Seen.of(level, Traced.eye(Vec3.ZERO, new Vec3(0, 0, 1), 1e-9), 2, 512, 1)
                .requireNear(left * 4 + 1 - left, 0, 0.01);
    }

    /** A cloud beside black walls is as bright with bounces as without. */
    @Test
    void blackWallsReflectNothingIntoClouds() {
        TestLevel level = new TestLevel()
                .skyLight()
                .sky(new Sky.Gradient(new Vec3(0.1, 0.3, 0.9), TestLevel.grey(0.6), new Vec3(0.2, 0.1, 0)))
                .castingSun(new Vec3(1, 2, 0.5), 3)
                .material("black", Vec3.ZERO)
                .box("black", new Vec3(0, -3, 0), new Vec3(40, 1, 40))
                .box("black", new Vec3(3, 2, 1), new Vec3(1, 6, 3))
                .cloud(Vec3.ZERO, new Vec3(4, 4, 4), 1, 0.95, 0.5);
        Pinhole eye = Traced.eye(new Vec3(-2, 1, 6), Vec3.ZERO, 0.3);
        Seen direct = Seen.of(level, eye, LightTransport.DIRECT, 8, 256, 1);
        Seen.of(level, eye, 8, 256, 2).requireNear(direct.mean, direct.error, 0.02);
    }

    /** A wall keeps a lamp's light from a cloud, and a white wall behind the cloud makes it brighter. */
    @Test
    void wallsShadeCloudsAndLightThem() {
        TestLevel black = besideWalls(Vec3.ZERO, true);
        Pinhole eye = Traced.eye(new Vec3(0, 0, 6), Vec3.ZERO, 0.15);
        double lit = Seen.of(besideWalls(Vec3.ZERO, false), eye, 4, 64, 1).mean;
        assertTrue(lit > 1e-3, "lit: " + lit);
        assertEquals(0, Seen.of(black, eye, 4, 64, 1).mean);
        double reflected = Seen.of(besideWalls(TestLevel.grey(0.9), true), eye, 4, 256, 1).mean;
        assertTrue(reflected > 0.02 * lit && reflected < lit, "around the screen: " + reflected + " of " + lit);
    }

    /** A lamp beside a cloud, a wall of a colour behind both, and a screen between them if wanted. */
    private static TestLevel besideWalls(Vec3 colour, boolean screened) {
        TestLevel level = new TestLevel()
                .light(lamp(new Vec3(4, 0, 0), 20))
                .material("wall", colour)
                .box("wall", new Vec3(0, 0, -5), new Vec3(20, 20, 1))
                .cloud(Vec3.ZERO, TestLevel.grey(2), 1, 0.9, 0);
        return screened ? level.box("wall", new Vec3(2, 0, 0), new Vec3(0.1, 4, 4)) : level;
    }

    /** Two rooms with clouds, beside each other with a doorway or apart with a pair of portals in its place. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void aPairOfPortalsLightsCloudsAsADoorwayDoes(int seed) {
        Random random = new Random(seed);
        double wide = 1 + random.nextDouble();
        double high = 1 + 1.5 * random.nextDouble();
        Vec3 lamp = new Vec3(2.5 * random.nextDouble() - 1.2, 1.2 * random.nextDouble(), -1 - 2 * random.nextDouble());
        Vec3 near = new Vec3(random.nextDouble() - 0.5, 0, 1.2);
        Vec3 sun = new Vec3(random.nextDouble() - 0.5, 0.5, -0.5 - random.nextDouble());
        Pinhole eye = Traced.eye(new Vec3(1.2, 0.6, 3.2), new Vec3(-0.6, -1, 0.4), 0.7);
        double rest = (4.4 - wide) / 2;
        double over = (3.4 - high) / 2;
        TestLevel doorway = rooms(0, lamp, near, sun)
                .box("wall", new Vec3((wide + rest) / 2, 0, 0), new Vec3(rest, 3.4, 1e-4))
                .box("wall", new Vec3(-(wide + rest) / 2, 0, 0), new Vec3(rest, 3.4, 1e-4))
                .box("wall", new Vec3(0, (high + over) / 2, 0), new Vec3(wide, over, 1e-4))
                .box("wall", new Vec3(0, -(high + over) / 2, 0), new Vec3(wide, over, 1e-4));
        TestLevel pair = rooms(50, lamp, near, sun)
                .box("wall", new Vec3(0, 0, -0.5), new Vec3(4.4, 3.4, 1))
                .box("wall", new Vec3(50, 0, 0.5), new Vec3(4.4, 3.4, 1))
                .portal("a", "b", Vec3.ZERO, new Vec3(0, 0, 1), wide, high)
                .portal("b", "a", new Vec3(50, 0, 0), new Vec3(0, 0, -1), wide, high);
        Seen open = Seen.of(doorway, eye, 6, 224, seed);
        Seen.of(pair, eye, 6, 224, seed + 100).requireNear(open.mean, open.error, 0.1);
    }

    /** A roofed room around z = 2 and one around z = −2 with a lamp, a lit face and a gap in its roof; a cloud in each. */
    private static TestLevel rooms(double apart, Vec3 lamp, Vec3 near, Vec3 sun) {
        Material glow = new Material("glow", TestLevel.grey(0.2), null, null, null, null, new Vec3(6, 3, 1), 1);
        Vec3 offset = new Vec3(apart, 0, 0);
        TestLevel level = new TestLevel()
                .skyLight()
                .sky(new Sky.Constant(new Vec3(0.4, 0.6, 1)))
                .castingSun(sun, 5)
                .material("wall", new Vec3(0.8, 0.7, 0.5))
                .material(glow)
                .light(lamp(lamp.plus(offset), 4))
                .cloud(near, new Vec3(2, 2, 2), 1, 0.9, 0.5)
                .cloud(offset.plus(new Vec3(0, -0.5, -1.5)), new Vec3(3, 2, 2.6), 0.7, 1, 0);
        for (Vec3 at : new Vec3[] {new Vec3(0, 0, 2.1), offset.plus(new Vec3(0, 0, -2.1))}) {
            double end = at.z() > 0 ? 2 : -2;
            level.box("wall", at.plus(new Vec3(0, -1.6, 0)), new Vec3(4.4, 0.2, 4.2))
                    .box("wall", at.plus(new Vec3(0, 0, end)), new Vec3(4.4, 3.4, 0.2))
                    .box("wall", at.plus(new Vec3(2.1, 0, 0)), new Vec3(0.2, 3.4, 4.2))
                    .box("wall", at.plus(new Vec3(-2.1, 0, 0)), new Vec3(0.2, 3.4, 4.2));
        }
        return level.box("wall", new Vec3(0, 1.6, 2.1), new Vec3(4.4, 0.2, 4.2))
                .box("wall", offset.plus(new Vec3(0, 1.6, -0.5)), new Vec3(4.4, 0.2, 1))
                .box("wall", offset.plus(new Vec3(0, 1.6, -3.35)), new Vec3(4.4, 0.2, 1.7))
                .box("glow", offset.plus(new Vec3(-1.2, -1.1, -3)), TestLevel.grey(0.6));
    }
}
