package nephele.engine.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.joml.Matrix3d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

class NormalsTest {
    private static final double[] SCALES = {0, 1e-30, -1e-30, 1e-3, -1e-3, 1, -1, 1e3, -1e3};

    /** n · t| ≤ 10⁻⁵ |t| holds for every transformed tangent, for all combinations of extreme scales. */
    @Test
    void theNormalStaysPerpendicularToEveryTransformedTangent() {
        var random = new SplittableRandom(11);
        for (double x : SCALES) {
            for (double y : SCALES) {
                for (double z : SCALES) {
                    Matrix3d linear = new Matrix3d()
                            .rotateXYZ(random.nextDouble(6), random.nextDouble(6), random.nextDouble(6))
                            .scale(x, y, z);
                    check(linear, unit(BasisTest.randomDirection(random)), random);
                    check(linear, new Vec3(0, -1, 0), random);
                    check(new Matrix3d().scaling(x, y, z), new Vec3(0.6, 0, 0.8), random);
                }
            }
        }
    }

    private static void check(Matrix3d linear, Vec3 normal, SplittableRandom random) {
        Vec3 transformed = Normals.transformed(linear, normal);
        String what = linear + " applied to " + normal;
        assertEquals(1, transformed.length(), 1e-12, what);
        for (int i = 0; i < 4; i++) {
            Vec3 tangent = normal.cross(BasisTest.randomDirection(random));
            Vector3d t = linear.transform(tangent.toVector());
            double along = transformed.x() * t.x + transformed.y() * t.y + transformed.z() * t.z;
            assertTrue(Math.abs(along) <= 1e-5 * t.length(), what);
        }
        Vector3d inside = linear.transform(normal.toVector());
        double towards = transformed.x() * inside.x + transformed.y() * inside.y + transformed.z() * inside.z;
        assertTrue(towards >= -1e-5 * inside.length(), "the normal changed sides: " + what);
    }

    private static Vec3 unit(Vec3 v) {
        return Directions.unit(v.x(), v.y(), v.z());
    }

    @Test
    void mirroringFlipsTheWinding() {
        assertFalse(Normals.flipsWinding(new Matrix3d().scaling(1, 1e-200, 1e200)));
        assertTrue(Normals.flipsWinding(new Matrix3d().scaling(1, -1e-200, 1)));
        assertFalse(Normals.flipsWinding(new Matrix3d().scaling(-1, -1, 1)));
        assertTrue(Normals.flipsWinding(new Matrix3d().scaling(-1, -1, -1)));
    }
}
