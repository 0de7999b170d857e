package nephele.engine.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.joml.Quaterniond;
import org.joml.Quaternionf;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

class RotationsTest {
    /**
     * 10⁶ rotations by 0.05 rad, renormalised every 1000, keep norm and angle: to 10⁻⁹ in double, to 2·10⁻⁷ as float.
     */
    @Test
    void aMillionRotationsKeepNormAndAngle() {
        Vec3 axis = new Vec3(0.6, 0, 0.8);
        Quaterniond step = Rotations.aroundAxis(axis, 0.05);
        Quaterniond q = new Quaterniond();
        int steps = 1_000_000;
        for (int i = 1; i <= steps; i++) {
            q.mul(step);
            if (i % Rotations.STEPS_BETWEEN_RENORMALISATIONS == 0) {
                q = Rotations.normalised(q);
            }
        }
        Quaterniond expected = Rotations.aroundAxis(axis, Math.IEEEremainder(0.05 * steps, 2 * Math.PI));
        double sign = q.dot(expected) < 0 ? -1 : 1;
        assertEquals(1, Math.sqrt(q.lengthSquared()), 1e-12);
        assertEquals(expected.x * sign, q.x, 1e-9);
        assertEquals(expected.z * sign, q.z, 1e-9);
        assertEquals(expected.w * sign, q.w, 1e-9);
        Quaternionf stored = new Quaternionf(q);
        assertEquals(1, Math.sqrt(stored.lengthSquared()), 2e-7);
        assertEquals(q.w, stored.w, 2e-7);
    }

    @Test
    void hostileQuaternionsBecomeTheIdentityOrUnit() {
        double inf = Double.POSITIVE_INFINITY;
        assertEquals(new Quaterniond(), Rotations.normalised(new Quaterniond(0, 0, 0, 0)));
        assertEquals(new Quaterniond(), Rotations.normalised(new Quaterniond(inf, 0, 0, 0)));
        assertEquals(new Quaterniond(), Rotations.normalised(new Quaterniond(0, Double.NaN, 0, 1)));
        assertEquals(new Quaterniond(1, 0, 0, 0), Rotations.normalised(new Quaterniond(1e-300, 0, 0, 0)));
        assertEquals(new Quaterniond(0, 1, 0, 0), Rotations.normalised(new Quaterniond(0, 1e300, 0, 0)));
        assertEquals(new Quaterniond(), Rotations.aroundAxis(Vec3.ZERO, 1));
    }

    @Test
    void theRotationTurnsAsTheAxisSays() {
        Vector3d turned = Rotations.aroundAxis(new Vec3(0, 3, 0), Math.PI / 2).transform(new Vector3d(0, 0, -1));
        assertEquals(-1, turned.x, 1e-15);
    }

    /** Directions rotate by the share of their angle; opposite directions rotate around a chosen axis. */
    @Test
    void directionsTurnTowardsEachOther() {
        var random = new SplittableRandom(14);
        for (int i = 0; i < 100_000; i++) {
            Vec3 a = unit(i % 3 == 0 ? BasisTest.axisMovedByUlps(random) : BasisTest.randomDirection(random));
            Vec3 b = i % 4 == 0 ? a.negated() : unit(BasisTest.randomDirection(random));
            double share = random.nextDouble();
            Vec3 turned = Directions.slerp(a, b, share);
            assertEquals(1, turned.length(), 1e-9);
            assertEquals(share * Directions.angle(a, b), Directions.angle(a, turned), 1e-6);
            assertTrue(Directions.angle(b, Directions.slerp(a, b, 1)) < 1e-8);
        }
    }

    private static Vec3 unit(Vec3 v) {
        return Directions.unit(v.x(), v.y(), v.z());
    }
}
