package nephele.engine.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class YawPitchTest {
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
