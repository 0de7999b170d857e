package nephele.engine.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class YawPitchTest {
    /** C.2 row 8: over many mouse movements, ±10⁶ counts among them, the view jumps no more than the input. */
    @Test
    void theViewNeverTurnsFartherThanTheInput() {
        double radiansPerCount = 0.0022;
        var random = new SplittableRandom(8);
        YawPitch look = new YawPitch(0, 0);
        for (int i = 0; i < 100_000; i++) {
            boolean wild = i % 100 == 0;
            double yaw = radiansPerCount * (wild ? random.nextInt(-1_000_000, 1_000_001) : random.nextInt(-40, 41));
            double pitch = radiansPerCount * (wild ? random.nextInt(-1_000_000, 1_000_001) : random.nextInt(-40, 41));
            YawPitch from = look;
            YawPitch next = from.turned(yaw, pitch);
            assertTrue(next.yaw() >= -Math.PI && next.yaw() < Math.PI, next::toString);
            assertTrue(Math.abs(next.pitch()) <= YawPitch.GREATEST_PITCH, next::toString);
            double turn = Directions.angle(look.basis().back(), next.basis().back());
            assertTrue(turn <= Math.abs(yaw) + Math.abs(pitch) + 1e-9, () -> from + " to " + next);
            double yawError = YawPitch.wrapped(next.yaw() - look.yaw() - yaw);
            assertEquals(0, yawError, 1e-9 * (1 + Math.abs(yaw)), "yaw lost in wrapping");
            look = next;
        }
        BasisTest.assertOrthonormal(look.basis(), 1e-12);
    }

    @Test
    void anglesWrapIntoTheHalfOpenTurn() {
        assertEquals(-Math.PI, YawPitch.wrapped(Math.PI));
        assertEquals(-Math.PI, YawPitch.wrapped(-Math.PI));
        assertEquals(1, YawPitch.wrapped(1 + 2e3 * Math.PI), 1e-9);
        assertEquals(Math.nextDown(Math.PI), YawPitch.wrapped(Math.nextDown(Math.PI)));
        for (int k = -1000; k <= 1000; k++) {
            double wrapped = YawPitch.wrapped(k * Math.PI);
            assertTrue(wrapped >= -Math.PI && wrapped < Math.PI, k + " half turns: " + wrapped);
        }
        assertEquals(0, YawPitch.wrapped(Double.NaN));
        assertEquals(new YawPitch(1, 1), new YawPitch(1, 1).turned(Double.NaN, Double.POSITIVE_INFINITY));
    }

    /** C.2 row 10: yaw from a direction, in all four quadrants and without one. */
    @Test
    void theYawOfADirectionIsRightInEveryQuadrant() {
        for (int i = 0; i < 3600; i++) {
            double yaw = YawPitch.wrapped(Math.toRadians(i * 0.1));
            Vec3 back = Basis.ofYawPitch(yaw, 0).back();
            assertEquals(0, YawPitch.wrapped(YawPitch.yawOf(-back.x(), -back.z()) - yaw), 1e-6);
        }
        assertEquals(0, YawPitch.yawOf(0, -0.0));
    }
}
