package nephele.engine.sim.player;

import nephele.engine.sim.state.Action;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerDimensions.Stance;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.ViewAngles;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** The move intent: the horizontal velocity that an input requests, m/s. */
final class MoveIntent {
    private final Vector3d velocity = new Vector3d();

    void of(PlayerMotion player, PlayerInput input) {
        ViewAngles heading = player.look().heading();
        double sin = StrictMath.sin(heading.yawRadians());
        double cos = StrictMath.cos(heading.yawRadians());
        double forward = input.forwardPercent() / 100.0;
        double right = input.rightPercent() / 100.0;
        velocity.set(right * cos - forward * sin, 0, -right * sin - forward * cos);
        double length = velocity.length();
        velocity.mul(speed(player.stance(), input) / Math.max(1, length));
    }

    /** Replaces the horizontal velocity. */
    void turn(Vector3dc changed) {
        velocity.set(changed);
    }

    private static double speed(Stance stance, PlayerInput input) {
        if (stance == Stance.CROUCHED) {
            return PlayerDimensions.CROUCH_METRES_PER_SECOND;
        }
        return input.holds(Action.RUN)
                ? PlayerDimensions.RUN_METRES_PER_SECOND
                : PlayerDimensions.WALK_METRES_PER_SECOND;
    }

    Vector3dc velocity() {
        return velocity;
    }

    double length() {
        return velocity.length();
    }

    double x() {
        return velocity.x;
    }

    double z() {
        return velocity.z;
    }
}
