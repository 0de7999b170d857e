package nephele.engine.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.stream.Stream;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests curves through points. */
class CatmullRomTest {
    private static final Vec3 A = new Vec3(1, 2, 3);
    private static final Vec3 B = new Vec3(4, 0, -1);

    enum Loop {
        UNIFORM(CatmullRom::uniformLoop),
        CENTRIPETAL(CatmullRom::centripetalLoop);

        private final Function<List<Vec3>, CatmullRom> of;

        Loop(Function<List<Vec3>, CatmullRom> of) {
            this.of = of;
        }
    }

    private static Vector3d position(CatmullRom curve, double at) {
        return curve.position(at, new Vector3d());
    }

    private static Vector3d derivative(CatmullRom curve, double at) {
        return curve.derivative(at, new Vector3d());
    }

    /** Through points of a parabola at uneven times the curve is that parabola, except for the spans at its ends. */
    @Test
    void pointsOfAParabolaGiveTheParabola() {
        double[] seconds = {0, 0.5, 2, 2.25, 5, 6};
        List<Vec3> points = new ArrayList<>();
        for (double t : seconds) {
            points.add(parabola(t));
        }
        CatmullRom curve = CatmullRom.timed(points, seconds);
        for (double t = 0.5; t <= 5; t += 0.03125) {
            assertEquals(0, position(curve, t).distance(parabola(t).toVector()), 1e-12, "at " + t);
            assertEquals(0, derivative(curve, t).distance(new Vector3d(2, 1 - t, 6 * t)), 1e-12, "at " + t);
        }
    }

    private static Vec3 parabola(double t) {
        return new Vec3(1 + 2 * t, t - t * t / 2, 3 * t * t);
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
        CatmullRom loop = CatmullRom.uniformLoop(points);
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
        CatmullRom curve = CatmullRom.uniformLoop(points);
        for (int i = -count; i < 3 * count; i++) {
            Vector3d point = points.get(Math.floorMod(i, count)).toVector();
            assertEquals(0, position(curve, (double) i / count).distance(point), 1e-12);
        }
    }

    /** Halfway between points the weights are −1/16, 9/16, 9/16, −1/16 (Catmull and Rom 1974). */
    @Test
    void aUniformLoopIsCatmullsAndRoms() {
        CatmullRom curve = CatmullRom.uniformLoop(
                List.of(new Vec3(0, 0, 0), new Vec3(2, 0, 0), new Vec3(3, 5, 0), new Vec3(0, 5, 1)));
        assertEquals(0, position(curve, 0.125).distance(1.125 - 3 / 16.0, -10 / 16.0, -1 / 16.0), 1e-12);
    }

    @ParameterizedTest
    @EnumSource
    void everyPointIsOnTheCurveAtItsKnot(Loop loop) {
        var random = new SplittableRandom(1);
        for (int trial = 0; trial < 200; trial++) {
            List<Vec3> points = randomPoints(random);
            CatmullRom curve = loop.of.apply(points);
            for (int i = 0; i < points.size(); i++) {
                assertEquals(
                        0, position(curve, curve.knot(i)).distance(points.get(i).toVector()), 1e-6);
            }
        }
    }

    /** Each derivative is the rate of change of the one before it. */
    @Test
    void derivativesAreThoseOfThePosition() {
        List<Vec3> points = List.of(A, B, new Vec3(0, 5, 0), new Vec3(-3, 1, 2), new Vec3(4, 4, 4));
        CatmullRom curve = CatmullRom.centripetalLoop(points);
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
     * Positions and derivatives are continuous at every knot and at the end, even for coincident, single and two
     * points.
     */
    @ParameterizedTest
    @EnumSource
    void loopsAreClosedSmoothAndFinite(Loop loop) {
        var random = new SplittableRandom(2);
        for (int trial = 0; trial < 300; trial++) {
            List<Vec3> points = randomPoints(random);
            CatmullRom curve = loop.of.apply(points);
            assertEquals(0, position(curve, 0).distance(position(curve, 1 - 1e-12)), 1e-4);
            assertEquals(0, derivative(curve, 0).distance(derivative(curve, 1 - 1e-12)), 1e-4);
            for (int i = 1; i <= 2000; i++) {
                assertTrue(position(curve, i / 1000.0).isFinite());
                assertTrue(derivative(curve, i / 1000.0).isFinite());
            }
            for (int i = 1; i < points.size(); i++) {
                assertNoJump(curve, curve.knot(i));
            }
        }
    }

    /** Asserts that around a knot nothing changes by more than its derivative explains. */
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

    /** The derivative is the same just before and after each knot, for any knots. */
    @Test
    void theDerivativeHasNoJumpAtAnyKnot() {
        var random = new SplittableRandom(3);
        for (int trial = 0; trial < 500; trial++) {
            List<Vec3> points = randomPoints(random);
            double[] seconds = new double[points.size()];
            for (int i = 1; i < seconds.length; i++) {
                seconds[i] = seconds[i - 1] + random.nextDouble(0.5, 3);
            }
            CatmullRom curve = CatmullRom.timed(points, seconds);
            for (int i = 1; i < seconds.length - 1; i++) {
                assertEquals(
                        0, position(curve, seconds[i]).distance(points.get(i).toVector()), 1e-6);
                Vector3d jump = derivative(curve, seconds[i] - 1e-9).sub(derivative(curve, seconds[i] + 1e-9));
                assertEquals(0, jump.length(), 1e-5);
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    void theDerivativeIsThePositionsChange(Loop loop) {
        CatmullRom curve = loop.of.apply(List.of(A, B, new Vec3(0, 5, 0), new Vec3(0, 5, 0), new Vec3(-3, 1, 2)));
        for (int i = 0; i < 1000; i++) {
            double at = (i + 0.5) / 1000;
            Vector3d difference =
                    position(curve, at + 1e-6).sub(position(curve, at - 1e-6)).div(2e-6);
            assertEquals(0, difference.distance(derivative(curve, at)), 1e-2);
        }
    }

    /** Uniform curves overshoot beside a short span, centripetal ones do not (Yuksel, Schaefer and Keyser 2011). */
    @Test
    void centripetalCurvesDoNotOvershootBesideShortSpans() {
        List<Vec3> points = List.of(new Vec3(0, 0, 0), new Vec3(10, 0, 0), new Vec3(10.1, 0.1, 0), new Vec3(10, 10, 0));
        assertTrue(farthest(CatmullRom.timed(points, new double[] {0, 1 / 3.0, 2 / 3.0, 1})) > 10.6);
        assertTrue(farthest(CatmullRom.centripetal(points)) < 10.2);
    }

    private static double farthest(CatmullRom curve) {
        double farthest = 0;
        for (int i = 0; i <= 1000; i++) {
            farthest = Math.max(farthest, position(curve, i / 1000.0).x);
        }
        return farthest;
    }

    @Test
    void oneTimeIsForEver() {
        CatmullRom still = CatmullRom.timed(List.of(A), new double[] {5});
        for (double at : new double[] {-1e9, 0, 5, 1e9, Double.NaN}) {
            assertEquals(A.toVector(), position(still, at));
            assertEquals(new Vector3d(), derivative(still, at));
        }
        assertEquals(0, position(CatmullRom.uniformLoop(List.of(A)), 0.3).distance(A.toVector()), 1e-12);
    }

    @Test
    void theLastOfEqualTimesCounts() {
        CatmullRom curve = CatmullRom.timed(List.of(B, A, B, A), new double[] {0, 0, 1, 1});
        assertEquals(A.toVector(), position(curve, 0));
        assertEquals(A.toVector(), position(curve, 0.5));
        assertEquals(A.toVector(), position(curve, 1));
    }

    @Test
    void timesThatDecreaseOrAreNoneAreRefused() {
        List<Vec3> two = List.of(A, B);
        assertThrows(IllegalArgumentException.class, () -> CatmullRom.timed(two, new double[] {1, 0}));
        assertThrows(IllegalArgumentException.class, () -> CatmullRom.timed(two, new double[] {0, Double.NaN}));
        assertThrows(IllegalArgumentException.class, () -> CatmullRom.timed(two, new double[] {0}));
        assertThrows(IllegalArgumentException.class, () -> CatmullRom.timed(List.of(), new double[] {}));
        assertThrows(IllegalArgumentException.class, () -> CatmullRom.uniformLoop(List.of()));
        assertThrows(IllegalArgumentException.class, () -> CatmullRom.uniformLoop(List.of(new Vec3(0, Double.NaN, 0))));
    }

    @Test
    void beyondItsEndsAnOpenCurveStandsStill() {
        CatmullRom curve = CatmullRom.centripetal(List.of(A, B));
        assertEquals(A.toVector(), position(curve, -1));
        assertEquals(B.toVector(), position(curve, 2));
        assertEquals(new Vector3d(), derivative(curve, 2));
        assertTrue(derivative(curve, 0.5).length() > 1);
    }
}
