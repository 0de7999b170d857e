package nephele.engine.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class BasisTest {
    static void assertOrthonormal(Basis b, double tolerance) {
        assertEquals(1, b.right().length(), tolerance, b::toString);
        assertEquals(1, b.up().length(), tolerance, b::toString);
        assertEquals(1, b.back().length(), tolerance, b::toString);
        assertEquals(0, b.right().dot(b.up()), tolerance, b::toString);
        assertEquals(0, b.right().dot(b.back()), tolerance, b::toString);
        assertEquals(0, b.up().dot(b.back()), tolerance, b::toString);
        assertEquals(1, b.right().dot(b.up().cross(b.back())), tolerance, b::toString);
    }

    static Vec3 axisMovedByUlps(SplittableRandom random) {
        double[] v = new double[3];
        v[random.nextInt(3)] = random.nextBoolean() ? 1 : -1;
        for (int i = 0; i < 3; i++) {
            v[i] = v[i] == 0 ? random.nextInt(-3, 4) * Double.MIN_VALUE : v[i] + random.nextInt(-3, 4) * Math.ulp(1.0);
        }
        return new Vec3(v[0], v[1], v[2]);
    }

    static Vec3 randomDirection(SplittableRandom random) {
        return new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
    }

    /** The frame is orthonormal to 10⁻⁶ with determinant +1 for 10⁵ directions, among them the axes ± k ulp. */
    @Test
    void lookingAnywhereGivesARightHandedOrthonormalFrame() {
        var random = new SplittableRandom(7);
        for (int i = 0; i < 100_000; i++) {
            Vec3 direction = i % 2 == 0 ? axisMovedByUlps(random) : randomDirection(random);
            double scale = i % 5 == 0 ? 1e-200 : i % 7 == 0 ? 1e200 : 1;
            Vec3 target = direction.scaled(scale);
            Vec3 up = i % 3 == 0 ? axisMovedByUlps(random) : i % 11 == 0 ? target : new Vec3(0, 1, 0);
            Basis basis = Basis.lookAt(Vec3.ZERO, target, up, Basis.WORLD);
            assertOrthonormal(basis, 1e-6);
            assertTrue(basis.back().dot(Directions.unit(target.x(), target.y(), target.z())) < -1 + 1e-12);
            assertTrue(basis.up().dot(Directions.unit(up.x(), up.y(), up.z())) >= -1e-6);
        }
    }

    /** With the eye at the target the last frame is kept; an up that is zero or NaN is replaced. */
    @Test
    void withoutADirectionTheLastFrameStays() {
        Basis last = Basis.ofYawPitch(1, 0.5);
        Vec3 up = new Vec3(0, 1, 0);
        assertSame(last, Basis.lookAt(new Vec3(1, 2, 3), new Vec3(1, 2, 3), up, last));
        assertSame(last, Basis.lookAt(Vec3.ZERO, new Vec3(Double.NaN, 0, 0), up, last));
        assertOrthonormal(Basis.lookAt(Vec3.ZERO, new Vec3(0, 0, -1), Vec3.ZERO, last), 1e-12);
        assertOrthonormal(Basis.lookAt(Vec3.ZERO, new Vec3(0, 0, -1), new Vec3(Double.NaN, 0, 0), last), 1e-12);
    }

    @Test
    void yawTurnsLeftAndPitchLooksUp() {
        assertClose(new Vec3(0, 0, 1), Basis.ofYawPitch(0, 0).back());
        assertClose(new Vec3(1, 0, 0), Basis.ofYawPitch(Math.PI / 2, 0).back());
        assertClose(new Vec3(0, -1, 0), Basis.ofYawPitch(0, Math.PI / 2).back());
        assertClose(new Vec3(0, 0, 1), Basis.ofYawPitch(0, Math.PI / 2).up());
        var random = new SplittableRandom(1);
        for (int i = 0; i < 1000; i++) {
            Basis b = Basis.ofYawPitch(random.nextDouble(-4, 4), random.nextDouble(-1.5, 1.5));
            assertOrthonormal(b, 1e-14);
            assertEquals(0, b.right().y(), 0);
            assertTrue(b.up().y() > 0);
        }
    }

    private static void assertClose(Vec3 expected, Vec3 actual) {
        assertEquals(expected.x(), actual.x(), 1e-15);
        assertEquals(expected.y(), actual.y(), 1e-15);
        assertEquals(expected.z(), actual.z(), 1e-15);
    }
}
