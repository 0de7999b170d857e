package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** What is drawn between two ticks when a portal was gone through in between. */
final class PlayerPoseTest {
    private static final Vec3 A = new Vec3(0, 1.05, -8);
    private static final Vec3 B = new Vec3(8, 1.05, 3);

    private static Lab hall() {
        return Lab.hall().pair(A, new Vec3(0, 0, 1), B, new Vec3(-1, 0, 0)).startAt(0, 0, -7, 0, 0);
    }

    /** Metres walked along the path through the portal: in front of the entry negative, beyond the exit positive. */
    private static double along(Vec3 eye) {
        boolean beforeEntry = Math.abs(eye.x()) < 1;
        assertTrue(beforeEntry || Math.abs(eye.z() - 3) < 1, "between the portals: " + eye);
        return beforeEntry ? -8 - eye.z() : 8 - eye.x();
    }

    /** The eye goes along the path at an even pace; it never sweeps through the room. */
    @Test
    void theEyeStaysOnThePath() {
        Lab lab = hall();
        boolean[] crossed = new boolean[1];
        double[] last = {along(lab.player().eye())};
        for (int i = 0; i < 120; i++) {
            SimState before = lab.state();
            SimState after = lab.tick(PlayerInput.FORWARD).state();
            crossed[0] |= after.around().trace().playerCrossed().length() > 0;
            for (int share = 1; share <= 8; share++) {
                PlayerPose pose = PlayerPose.between(before, after, share / 8.0);
                double now = along(pose.eye());
                assertTrue(now >= last[0] - 1e-9 && now - last[0] < 4.0 / 120 / 8 + 1e-6, last[0] + " to " + now);
                assertEquals(1.65, pose.eye().y(), 1e-6);
                last[0] = now;
            }
        }
        assertTrue(crossed[0]);
    }

    /** Before the crossing the view looks into the entry, after it away from the exit; never in between. */
    @Test
    void theViewTurnsWithThePortal() {
        Lab lab = hall();
        for (int i = 0; i < 120; i++) {
            SimState before = lab.state();
            SimState after = lab.tick(PlayerInput.FORWARD).state();
            for (double share = 0; share <= 1; share += 0.125) {
                PlayerPose pose = PlayerPose.between(before, after, share);
                Vector3d ahead = pose.view().back().toVector().negate();
                boolean isBeforeEntry = Math.abs(pose.eye().x()) < 1;
                Vector3d expected = isBeforeEntry ? new Vector3d(0, 0, -1) : new Vector3d(-1, 0, 0);
                assertEquals(0, ahead.distance(expected), 1e-9);
                assertEquals(1, pose.view().up().y(), 1e-9);
            }
        }
    }

    /** The eye may be beyond a portal that the body is before: it is drawn from there. */
    @Test
    void anEyeBeyondIsDrawnFromBeyond() {
        Lab lab = Lab.hall().pair(new Vec3(0, 3, 0), new Vec3(0, -1, 0), new Vec3(4, 0, 4), new Vec3(0, 1, 0));
        Vec3 feet = new Vec3(0, 1.5, 0);
        SimState state = lab.state().withPlayer(lab.player().withFeet(feet));
        PlayerPose pose = PlayerPose.between(state, state, 0.5);
        assertEquals(0.15, pose.eye().y(), 1e-9);
        assertEquals(4, pose.eye().x(), 1e-9);
    }
}
