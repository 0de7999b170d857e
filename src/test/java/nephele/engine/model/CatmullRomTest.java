package nephele.engine.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests curves through points. */
class CatmullRomTest {
    private static final Vec3 A = new Vec3(1, 2, 3);
    private static final Vec3 B = new Vec3(4, 0, -1);

    private static Vector3d position(CatmullRom curve, double at) {
        return curve.position(at, new Vector3d());
    }

    private static Vector3d derivative(CatmullRom curve, double at) {
        return curve.derivative(at, new Vector3d());
    }

    private static List<Vec3> randomPoints(SplittableRandom random) {
        List<Vec3> points = new ArrayList<>();
        int count = random.nextInt(1, 9);
        for (int i = 0; i < count; i++) {
            boolean coincident = i > 0 && random.nextInt(4) == 0;
            points.add(
                    coincident
                            ? points.get(i - 1)
                            : new Vec3(
                                    random.nextDouble(-10, 10),
                                    random.nextDouble(-10, 10),
                                    random.nextDouble(-10, 10)));
        }
        return points;
    }

    @Test
    void aUniformLoopPassesItsPointsAtEqualParameters() {
        List<Vec3> points = List.of(A, B, new Vec3(0, 5, 0), new Vec3(-3, 1, 2));
        CatmullRom loop = new CatmullRom(points);
        for (int i = 0; i < 8; i++) {
            assertEquals(0, position(loop, i / 4.0).distance(points.get(i % 4).toVector()), 1e-12);
        }
        Vector3d wanted = points.get(2).toVector().sub(A.toVector()).mul(0.5 * 4);
        assertEquals(0, derivative(loop, 0.25).distance(wanted), 1e-9, "half the neighbours' difference a span");
    }

    /** A uniform loop passes its points at equal intervals and repeats in both directions. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 16})
    void aUniformLoopGoesThroughItsPoints(int count) {
        var random = new SplittableRandom(count);
        List<Vec3> points = Stream.generate(
                        () -> new Vec3(random.nextDouble(9), random.nextDouble(), -random.nextDouble(5)))
                .limit(count)
                .toList();
        CatmullRom curve = new CatmullRom(points);
        for (int i = -count; i < 3 * count; i++) {
            Vector3d point = points.get(Math.floorMod(i, count)).toVector();
            assertEquals(0, position(curve, (double) i / count).distance(point), 1e-12);
        }
    }

    /** Halfway between points the weights are −1/16, 9/16, 9/16, −1/16 (Catmull and Rom 1974). */
    @Test
    void aUniformLoopIsCatmullsAndRoms() {
        CatmullRom curve =
                new CatmullRom(List.of(new Vec3(0, 0, 0), new Vec3(2, 0, 0), new Vec3(3, 5, 0), new Vec3(0, 5, 1)));
        assertEquals(0, position(curve, 0.125).distance(1.125 - 3 / 16.0, -10 / 16.0, -1 / 16.0), 1e-12);
    }

    @Test
    void everyPointIsOnTheCurve() {
        var random = new SplittableRandom(1);
        for (int trial = 0; trial < 200; trial++) {
            List<Vec3> points = randomPoints(random);
            CatmullRom curve = new CatmullRom(points);
            for (int i = 0; i < points.size(); i++) {
                assertEquals(
                        0,
                        position(curve, (double) i / points.size())
                                .distance(points.get(i).toVector()),
                        1e-6);
            }
        }
    }

    /** Each derivative is the rate of change of the one before it. */
    @Test
    void derivativesAreThoseOfThePosition() {
        List<Vec3> points = List.of(A, B, new Vec3(0, 5, 0), new Vec3(-3, 1, 2), new Vec3(4, 4, 4));
        CatmullRom curve = new CatmullRom(points);
        for (double at = 0.0013; at < 1; at += 0.01) {
            Vector3d change =
                    position(curve, at + 1e-6).sub(position(curve, at - 1e-6)).div(2e-6);
            assertEquals(0, change.distance(derivative(curve, at)), 1e-3);
            Vector3d bend = derivative(curve, at + 1e-6)
                    .sub(derivative(curve, at - 1e-6))
                    .div(2e-6);
            assertEquals(0, bend.distance(curve.secondDerivative(at, new Vector3d())), 1e-2);
        }
    }

    /**
     * Positions and derivatives are continuous at every point and at the end, even for coincident, single and two
     * points.
     */
    @Test
    void curvesAreClosedSmoothAndFinite() {
        var random = new SplittableRandom(2);
        for (int trial = 0; trial < 300; trial++) {
            List<Vec3> points = randomPoints(random);
            CatmullRom curve = new CatmullRom(points);
            assertEquals(0, position(curve, 0).distance(position(curve, 1 - 1e-12)), 1e-4);
            assertEquals(0, derivative(curve, 0).distance(derivative(curve, 1 - 1e-12)), 1e-4);
            for (int i = 1; i <= 2000; i++) {
                assertTrue(position(curve, i / 1000.0).isFinite());
                assertTrue(derivative(curve, i / 1000.0).isFinite());
            }
            for (int i = 1; i < points.size(); i++) {
                assertNoJump(curve, (double) i / points.size());
            }
        }
    }

    /** Asserts that around a point nothing changes by more than its derivative explains. */
    private static void assertNoJump(CatmullRom curve, double knot) {
        double before = knot - 1e-9;
        double after = knot + 1e-9;
        double speed =
                derivative(curve, before).length() + derivative(curve, after).length();
        assertEquals(0, position(curve, before).distance(position(curve, after)), 2e-9 * speed + 1e-12);
        double bend = curve.secondDerivative(before, new Vector3d()).length()
                + curve.secondDerivative(after, new Vector3d()).length();
        assertEquals(0, derivative(curve, before).distance(derivative(curve, after)), 2e-9 * bend + 1e-8);
    }

    @Test
    void onePointIsAConstantCurve() {
        CatmullRom still = new CatmullRom(List.of(A));
        for (double at : new double[] {-1e9, 0, 0.3, 5, 1e9, Double.NaN}) {
            assertEquals(0, position(still, at).distance(A.toVector()), 1e-12);
            assertEquals(new Vector3d(), derivative(still, at));
        }
    }

    @Test
    void noPointsAndPlacesThatAreNoneAreRefused() {
        assertThrows(IllegalArgumentException.class, () -> new CatmullRom(List.of()));
        assertThrows(IllegalArgumentException.class, () -> new CatmullRom(List.of(new Vec3(0, Double.NaN, 0))));
    }
}
