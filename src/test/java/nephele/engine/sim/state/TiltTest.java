package nephele.engine.sim.state;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import org.joml.Quaterniond;
import org.junit.jupiter.api.Test;

class TiltTest {
    private static final Vec3 UP = new Vec3(0, 1, 0);

    /**
     * A quaternion and its negative are the same rotation: both turn upright by the requested angle, by the shorter
     * way.
     */
    @Test
    void theViewTurnsUprightByTheShorterWay() {
        var random = new SplittableRandom(4);
        for (int i = 0; i < 500; i++) {
            Vec3 axis = new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
            double angle = random.nextDouble(0.2, Math.PI - 0.01);
            double step = random.nextDouble(0, 0.19);
            Quaterniond q = Rotations.aroundAxis(axis, angle);
            for (int sign = -1; sign <= 1; sign += 2) {
                Tilt nearer = new Tilt(UP, sign * q.x, sign * q.y, sign * q.z, sign * q.w).viewTowardsUpright(step);
                Quaterniond expected = Rotations.aroundAxis(axis, angle - step);
                assertEquals(1, Math.abs(expected.dot(nearer.turn())), 1e-12, "rotation " + i + ", sign " + sign);
                Tilt there =
                        new Tilt(UP, sign * q.x, sign * q.y, sign * q.z, sign * q.w).viewTowardsUpright(angle + 1e-9);
                assertEquals(Tilt.UPRIGHT, there);
            }
        }
    }
}
