package nephele.engine.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Vec3;
import nephele.workshop.prove.geometry.BruteForce;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SweepTest {
    private static final double SKIN = Sweep.SKIN_METRES;
    private static final RoundedHull PLAYER = RoundedHull.uprightCapsule(0.3, 1.8);

    /** A wall of 1 cm stops any speed, at the same place. */
    @ParameterizedTest
    @ValueSource(doubles = {0.001, 1, 10, 100, 1000, 10_000, 1e6, 1e9})
    void aThinWallStopsAnySpeed(double metres) {
        CollisionWorld world = Solids.world(Solids.box(0.01, 10, 10));
        Sweep sweep = new Sweep();
        Vector3d from = new Vector3d(-0.3055, 0, 0);
        Vector3d way = new Vector3d(metres, metres / 3, metres / 7);
        boolean hit = sweep.cast(world, PLAYER, from, way);
        assertEquals(metres > 0.002 || metres == 0.001, hit || metres == 0.001);
        double x = from.x + way.x * sweep.fraction();
        assertTrue(x <= -0.305 - SKIN + 2e-8 || from.x > -0.305 - SKIN, "reached " + x);
    }

    @Test
    void distancesAreThoseOfSchoolGeometry() {
        CollisionWorld world = Solids.world(Solids.box(2, 2, 2));
        Sweep sweep = new Sweep();
        assertTrue(sweep.cast(world, RoundedHull.sphere(0.5), new Vector3d(5, 0.3, 0), new Vector3d(-10, 0, 0)));
        assertEquals((5 - 1.5 - SKIN) / 10, sweep.fraction(), 1e-8);
        assertTrue(sweep.cast(world, RoundedHull.sphere(0.5), new Vector3d(5, 1.4, 0), new Vector3d(-10, 0, 0)));
        double reach = 0.5 + SKIN;
        assertEquals((5 - 1 - Math.sqrt(reach * reach - 0.16)) / 10, sweep.fraction(), 1e-8, "an edge");
        assertEquals(0.4 / reach, sweep.normal().y(), 1e-6);
        assertEquals(1, sweep.upmostNormal().y(), 0);
        assertTrue(sweep.cast(world, RoundedHull.sphere(0.5), new Vector3d(5, 1.2, 1.2), new Vector3d(-10, 0, 0)));
        assertEquals((5 - 1 - Math.sqrt(reach * reach - 0.08)) / 10, sweep.fraction(), 1e-8, "a corner");
        assertEquals(0, sweep.point().distance(1, 1, 1), 1e-9);
    }

    @Test
    void whatIsTouchedStopsOnlyWhoComesNearer() {
        CollisionWorld world = Solids.world(Solids.box(10, 2, 10));
        Sweep sweep = new Sweep();
        Vector3d resting = new Vector3d(0, 1 + 0.9 + SKIN, 0);
        assertFalse(sweep.cast(world, PLAYER, resting, new Vector3d(1000, 0, 0)));
        assertFalse(sweep.cast(world, PLAYER, resting, new Vector3d(0, 1, 0)));
        assertTrue(sweep.cast(world, PLAYER, resting, new Vector3d(1, -1e-3, 0)));
        assertEquals(0, sweep.fraction(), 1e-4);
        Vector3d sunk = new Vector3d(0, 1.2, 0);
        assertFalse(sweep.cast(world, PLAYER, sunk, new Vector3d(0, 1, 0)), "a way out is free");
        assertTrue(sweep.cast(world, PLAYER, sunk, new Vector3d(0, -1, 0)));
        assertEquals(0, sweep.fraction());
    }

    @Test
    void noWayIsNoHit() {
        CollisionWorld world = Solids.world(Solids.box(1, 1, 1));
        Sweep sweep = new Sweep();
        assertFalse(sweep.cast(world, PLAYER, new Vector3d(), new Vector3d()));
        assertFalse(sweep.cast(world, PLAYER, new Vector3d(9, 0, 0), new Vector3d(Double.NaN, 0, 0)));
        assertFalse(new Sweep().cast(Solids.world(), PLAYER, new Vector3d(), new Vector3d(1, 0, 0)));
    }

    /** Sweeps of capsules in any orientation against needles, plates, boxes and tilted solids equal bisection. */
    @Test
    void equalsBruteForce() {
        var random = new SplittableRandom(5);
        int hits = 0;
        for (int i = 0; i < 1500; i++) {
            ConvexPolyhedron solid = Solids.any(random);
            Vector3d half = random.nextBoolean() ? new Vector3d(0, 0.6, 0) : Solids.point(random, 1);
            Vector3d from = Solids.direction(random).mul(6 + 3 * random.nextDouble());
            Vector3d way = Solids.point(random, 2).sub(from).mul(1 + random.nextDouble());
            CollisionWorld world = Solids.world(solid);
            Sweep sweep = new Sweep();
            boolean hit = sweep.cast(world, RoundedHull.capsule(new Vec3(half.x, half.y, half.z), 0.3), from, way);
            hits += hit ? 1 : 0;
            double expected = fraction(half, from, way, 0.3 + SKIN, solid);
            double allowed = isGrazing(sweep, way) ? 1e-3 : 1e-6;
            assertEquals(expected * way.length(), sweep.fraction() * way.length(), allowed, "sweep " + i);
        }
        assertTrue(hits > 500 && hits < 1400, "hits: " + hits);
    }

    /**
     * Returns the first fraction of the displacement at which a capsule is {@code gap} from the solid, 1 for none. The
     * distance is convex along it, so that a ternary search finds the minimum and bisection the first place near
     * enough.
     */
    private static double fraction(Vector3d halfAxis, Vector3d from, Vector3d way, double gap, ConvexPolyhedron solid) {
        DoubleUnaryOperator excess = t -> {
            Vector3d centre = new Vector3d(way).mul(t).add(from);
            return BruteForce.distance(new Vector3d(centre).sub(halfAxis), new Vector3d(centre).add(halfAxis), solid)
                    - gap;
        };
        double nearest = leastBetweenZeroAndOne(excess);
        if (excess.applyAsDouble(nearest) > 0) {
            return 1;
        }
        double low = 0;
        for (int i = 0; i < 50; i++) {
            double middle = (low + nearest) / 2;
            if (excess.applyAsDouble(middle) > 0) {
                low = middle;
            } else {
                nearest = middle;
            }
        }
        return low;
    }

    private static double leastBetweenZeroAndOne(DoubleUnaryOperator convex) {
        double low = 0;
        double high = 1;
        for (int i = 0; i < 60; i++) {
            double third = (high - low) / 3;
            if (convex.applyAsDouble(low + third) < convex.applyAsDouble(high - third)) {
                high -= third;
            } else {
                low += third;
            }
        }
        return low;
    }

    /**
     * Returns true for a tangent displacement: it touches at a double root, known only to the root of the tolerance.
     */
    private static boolean isGrazing(Sweep sweep, Vector3d way) {
        return sweep.collider() < 0 || -sweep.normal().dot(way) < 0.02 * way.length();
    }

    /** A floor and a wall are touched at the start: the one with the lower index stops the sweep. */
    @Test
    void ofSolidsTouchedAtOnceTheFirstIsTold() {
        double[] floor = {-9, -9, -9, 9, 0, 9};
        double[] wall = {-9, 0, -9, 0, 9, 9};
        Vector3d touching = new Vector3d(0.3 + SKIN, 0.9 + SKIN, 0);
        for (double[][] order : new double[][][] {{floor, wall}, {wall, floor}}) {
            Sweep sweep = new Sweep();
            CollisionWorld world = PortalPairs.boxes(Vec3.ZERO, order);
            assertTrue(sweep.cast(world, PLAYER, touching, new Vector3d(-1, -1, 0)));
            assertEquals(0, sweep.fraction());
            assertEquals(0, sweep.collider());
            assertEquals(order[0] == floor ? 1 : 0, sweep.normal().y(), 1e-9);
        }
    }

    @Test
    void theOrderOfSolidsDoesNotMatter() {
        var random = new SplittableRandom(6);
        for (int i = 0; i < 200; i++) {
            ConvexPolyhedron a = Solids.any(random);
            ConvexPolyhedron b = Solids.any(random);
            Vector3d from = Solids.direction(random).mul(8);
            Vector3d way = new Vector3d(from).mul(-2);
            CollisionWorld ab = Solids.world(a, b);
            Sweep one = new Sweep();
            CollisionWorld ba = Solids.world(b, a);
            Sweep other = new Sweep();
            assertEquals(one.cast(ab, PLAYER, from, way), other.cast(ba, PLAYER, from, way));
            assertEquals(one.fraction(), other.fraction(), 1e-9);
        }
    }
}
