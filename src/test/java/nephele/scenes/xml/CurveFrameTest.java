package nephele.scenes.xml;

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

class CurveFrameTest {
    private static List<Vec3> random(Random random, int count) {
        List<Vec3> points = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            points.add(new Vec3(random.nextGaussian() * 5, random.nextGaussian(), random.nextGaussian() * 9));
        }
        return points;
    }

    @Test
    void coincidentPointsAndHugeTimesStayFinite() {
        Vec3 point = new Vec3(1, 2, 3);
        for (List<Vec3> points : List.of(
                List.of(point, point, point, point, point),
                List.of(point, point, Vec3.ZERO, Vec3.ZERO),
                List.of(point, new Vec3(1, 2 + 1e-15, 3), Vec3.ZERO))) {
            CurveFrame curve = new CurveFrame(points);
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
        List<Vec3> points = random(new Random(8), 9);
        CurveFrame curve = new CurveFrame(points);
        CatmullRom loop = new CatmullRom(points);
        for (double at = 0; at < 1; at += 0.003) {
            Matrix4d frame = new Matrix4d();
            curve.carryAligned(at, frame, new Matrix4d());
            Vector3d x = frame.getColumn(0, new Vector3d());
            Vector3d y = frame.getColumn(1, new Vector3d());
            Vector3d z = frame.getColumn(2, new Vector3d());
            assertEquals(0, x.distance(loop.derivative(at, new Vector3d()).normalize()), 1e-12);
            assertEquals(0, new Vector3d(x).cross(y).distance(z), 1e-12);
            assertEquals(0, z.y, 1e-12);
            assertTrue(y.y > 0);
            assertEquals(0, frame.getTranslation(new Vector3d()).distance(loop.position(at, new Vector3d())), 1e-12);
        }
    }

    @Test
    void onAVerticalStretchTheFrameIsStillOne() {
        CurveFrame curve =
                new CurveFrame(List.of(new Vec3(0, 0, 0), new Vec3(0, 4, 0), new Vec3(0, 9, 0), new Vec3(0, 2, 0)));
        for (double at = 0; at < 1; at += 0.01) {
            Matrix4d frame = new Matrix4d();
            curve.carryAligned(at, frame, new Matrix4d());
            assertEquals(1, frame.determinant3x3(), 1e-12);
            assertEquals(1, Math.abs(frame.m01()), 1e-12);
        }
    }
}
