package nephele.engine.sim.player;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.math.Vec3;
import nephele.engine.sim.Lab;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimState;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** The pose between two ticks is correct when the player went through a portal in between. */
final class PlayerPoseTest {
    private static final Vec3 A = new Vec3(0, 1.05, -8);
    private static final Vec3 B = new Vec3(8, 1.05, 3);

    private static Lab hall() {
        return Lab.hall().pair(A, new Vec3(0, 0, 1), B, new Vec3(-1, 0, 0)).startAt(0, 0, -7, 0, 0);
    }

    /**
     * Returns the metres walked along the path through the portal: negative before the entry, positive beyond the exit.
     */
    private static double along(Vec3 eye) {
        boolean beforeEntry = Math.abs(eye.x()) < 1;
        assertTrue(beforeEntry || Math.abs(eye.z() - 3) < 1, "between the portals: " + eye);
        return beforeEntry ? -8 - eye.z() : 8 - eye.x();
    }

    /** The eye moves along the path at an even pace and never sweeps through the room. */
    @Test
    void theEyeStaysOnThePath() {
        Lab lab = hall();
        boolean[] crossed = new boolean[1];
        double[] last = {along(lab.player().eye())};
        for (int i = 0; i < 120; i++) {
            SimState before = lab.state();
            SimState after = lab.tick(PlayerInput.FORWARD).state();
            crossed[0] |= after.world().trace().playerCrossed().length() > 0;
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

    /** The view is directed into the entry before the crossing and away from the exit after it, never in between. */
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

    /** An eye beyond a portal that the body is before is drawn from the space beyond. */
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
