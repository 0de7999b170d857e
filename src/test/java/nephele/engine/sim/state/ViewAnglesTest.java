package nephele.engine.sim.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import nephele.engine.sim.player.MouseLook;
import nephele.engine.sim.player.PlayerPose;
import org.junit.jupiter.api.Test;

/**
 * Yaw stays in [−π, π) and pitch within ±89.9°, without a change greater than the input in 1e6 turns, also for ±1e6
 * counts.
 */
class ViewAnglesTest {
    @Test
    void turnsByWhatTheMouseSaysAndNoMore() {
        var random = new SplittableRandom(1);
        ViewAngles heading = new ViewAngles(0, 0);
        for (int i = 0; i < 1_000_000; i++) {
            int most = i % 1000 == 0 ? 1_000_000 : 300;
            int left = random.nextInt(-most, most + 1);
            int up = random.nextInt(-most, most + 1);
            ViewAngles next = heading.turned(left, up);
            double turned = heading.yawRadiansTo(next) * 180_000 / Math.PI;
            assertEquals(0, Math.IEEEremainder(turned - left, 360_000), 1e-6);
            assertTrue(Math.abs(turned) <= Math.abs(left) + 1e-6, "jumped by " + turned + " for " + left);
            assertTrue(Math.abs(next.pitchMillidegrees() - heading.pitchMillidegrees()) <= Math.abs(up));
            assertTrue(next.yawRadians() >= -Math.PI && next.yawRadians() < Math.PI);
            assertTrue(Math.abs(next.pitchMillidegrees()) <= 89_900);
            heading = next;
        }
    }

    @Test
    void aMillionTurnsAndBackIsWhereItBegan() {
        ViewAngles heading = ViewAngles.ofDegrees(33.3, -12);
        ViewAngles turned = heading;
        for (int i = 0; i < 1_000_000; i++) {
            turned = turned.turned(77_777, 0);
        }
        for (int i = 0; i < 1_000_000; i++) {
            turned = turned.turned(-77_777, 0);
        }
        assertEquals(heading, turned);
    }

    @Test
    void anglesOfFilesAreWrapped() {
        assertEquals(new ViewAngles(-90_000, 0), ViewAngles.ofDegrees(270, 0));
        assertEquals(new ViewAngles(-180_000, 89_900), ViewAngles.ofDegrees(180, 95));
        assertEquals(new ViewAngles(0, 0), ViewAngles.ofDegrees(Double.NaN, Double.NaN));
        assertEquals(Math.PI / 2, new ViewAngles(90_000, 0).yawRadians(), 1e-15);
    }

    /** Slow mouse motion turns as far as fast motion: remainders below a thousandth of a degree are kept. */
    @Test
    void theMouseLosesNothing() {
        MouseLook look = new MouseLook(0.0001234);
        long left = 0;
        for (int i = 0; i < 100_000; i++) {
            left += look.turn(PlayerInput.NONE, -1, 0).turnLeftMillidegrees();
        }
        assertEquals(12_340, left, 1);
        PlayerInput wild = look.turn(PlayerInput.FORWARD, 1e12, Double.NaN);
        assertEquals(-PlayerInput.MAX_TURN_MILLIDEGREES, wild.turnLeftMillidegrees());
        assertEquals(0, wild.turnUpMillidegrees());
    }

    @Test
    void betweenTwoStatesTheEyeTurnsTheShorterWay() {
        SimState a = new SimState(
                0, 1, 0, PlayerState.standing(new nephele.engine.math.Vec3(0, 0, 0), new ViewAngles(179_000, 0)));
        SimState b = new SimState(
                1, 1, 0, PlayerState.standing(new nephele.engine.math.Vec3(1, 0, 0), new ViewAngles(-179_000, 50)));
        PlayerPose pose = PlayerPose.between(a, b, 0.75);
        assertEquals(Math.toRadians(-179.5), yaw(pose), 1e-12);
        assertEquals(0.75, pose.eye().x(), 1e-15);
        assertEquals(1.65, pose.eye().y(), 1e-15);
        assertEquals(Math.toRadians(179.5), yaw(PlayerPose.between(a, b, 0.25)), 1e-12);
        assertEquals(Math.toRadians(-179), yaw(PlayerPose.between(a, b, 1)), 1e-12);
    }

    private static double yaw(PlayerPose pose) {
        return StrictMath.atan2(pose.view().back().x(), pose.view().back().z());
    }
}
