package nephele.engine.xmlscene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import nephele.engine.math.Vec3;
import nephele.engine.model.CatmullRom;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ClosedCurveTest {
    private static List<Vec3> random(Random random, int count) {
        List<Vec3> points = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            points.add(new Vec3(random.nextGaussian() * 5, random.nextGaussian(), random.nextGaussian() * 9));
        }
        return points;
    }

    private static Vector3d position(ClosedCurve curve, double round) {
        Vector3d at = new Vector3d();
        curve.position(round, at);
        return at;
    }

    private static Vector3d derivative(ClosedCurve curve, double round) {
        Vector3d rate = new Vector3d();
        curve.derivative(round, rate);
        return rate;
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 16})
    void itGoesThroughItsPointsInEqualTimesAndRoundAgain(int count) {
        List<Vec3> points = random(new Random(count), count);
        ClosedCurve curve = new ClosedCurve(points);
        for (int i = -count; i < 3 * count; i++) {
            Vector3d point = points.get(Math.floorMod(i, count)).toVector();
            assertEquals(0, position(curve, (double) i / count).distance(point), 1e-12);
        }
    }

    /** Position and velocity just before a point are those at it: C1, where the loop closes too. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 16})
    void itHasNoCorner(int count) {
        ClosedCurve curve = new ClosedCurve(random(new Random(count), count));
        for (int i = 0; i <= count; i++) {
            double at = (double) i / count;
            double before = at - 1e-10;
            assertEquals(0, position(curve, before).distance(position(curve, at)), 1e-7);
            assertEquals(0, derivative(curve, before).distance(derivative(curve, at)), 1e-4);
        }
    }

    @Test
    void itsDerivativeIsThatOfItsPosition() {
        ClosedCurve curve = new ClosedCurve(random(new Random(3), 7));
        for (double at = 0.001; at < 1; at += 0.01) {
            Vector3d difference = position(curve, at + 1e-6).sub(position(curve, at - 1e-6));
            assertEquals(0, difference.div(2e-6).distance(derivative(curve, at)), 1e-3);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 16})
    void itIsTheUniformCatmullRomCurveThatAllocates(int count) {
        List<Vec3> points = random(new Random(count), count);
        ClosedCurve curve = new ClosedCurve(points);
        CatmullRom twin = CatmullRom.uniformLoop(points);
        for (double at = -0.5; at < 1.5; at += 0.0137) {
            assertEquals(0, position(curve, at).distance(twin.position(at, new Vector3d())), 1e-11);
            assertEquals(0, derivative(curve, at).distance(twin.derivative(at, new Vector3d())), 1e-9);
        }
    }

    @Test
    void itTurnsAtAPointParallelToItsNeighbours() {
        ClosedCurve curve =
                new ClosedCurve(List.of(new Vec3(0, 0, 0), new Vec3(2, 0, 0), new Vec3(3, 5, 0), new Vec3(0, 5, 1)));
        // (p2 − p0) / 2 a segment, four segments a round.
        assertEquals(0, derivative(curve, 0.25).distance(6, 10, 0), 1e-12);
        // Half-way between points: −1/16, 9/16, 9/16, −1/16.
        assertEquals(0, position(curve, 0.125).distance(1.125 - 3 / 16.0, -10 / 16.0, -1 / 16.0), 1e-12);
    }

    @Test
    void coincidentPointsAndHugeTimesStayFinite() {
        Vec3 point = new Vec3(1, 2, 3);
        for (List<Vec3> points : List.of(
                List.of(point, point, point, point, point),
                List.of(point, point, Vec3.ZERO, Vec3.ZERO),
                List.of(point, new Vec3(1, 2 + 1e-15, 3), Vec3.ZERO))) {
            ClosedCurve curve = new ClosedCurve(points);
            for (double round : new double[] {0, 0.1, 0.5, 0.999, 1, -1e-17, 1e-300, 123456.7, 1e300}) {
                Matrix4d frame = new Matrix4d();
                curve.carryAligned(round, frame, new Matrix4d());
                assertTrue(frame.isFinite(), () -> points + " at " + round);
                assertEquals(1, frame.determinant3x3(), 1e-9);
            }
        }
    }

    @Test
    void anAlignedFrameLooksAlongTheCurveUprightAndUnskewed() {
        ClosedCurve curve = new ClosedCurve(random(new Random(8), 9));
        for (double at = 0; at < 1; at += 0.003) {
            Matrix4d frame = new Matrix4d();
            curve.carryAligned(at, frame, new Matrix4d());
            Vector3d x = frame.getColumn(0, new Vector3d());
            Vector3d y = frame.getColumn(1, new Vector3d());
            Vector3d z = frame.getColumn(2, new Vector3d());
            assertEquals(0, x.distance(derivative(curve, at).normalize()), 1e-12);
            assertEquals(0, new Vector3d(x).cross(y).distance(z), 1e-12);
            assertEquals(0, z.y, 1e-12);
            assertTrue(y.y > 0);
            assertEquals(0, frame.getTranslation(new Vector3d()).distance(position(curve, at)), 1e-12);
        }
    }

    @Test
    void onAVerticalStretchTheFrameIsStillOne() {
        ClosedCurve curve =
                new ClosedCurve(List.of(new Vec3(0, 0, 0), new Vec3(0, 4, 0), new Vec3(0, 9, 0), new Vec3(0, 2, 0)));
        for (double at = 0; at < 1; at += 0.01) {
            Matrix4d frame = new Matrix4d();
            curve.carryAligned(at, frame, new Matrix4d());
            assertEquals(1, frame.determinant3x3(), 1e-12);
            assertEquals(1, Math.abs(frame.m01()), 1e-12);
        }
    }
}
