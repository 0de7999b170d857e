package nephele.engine.sim.player;

import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerState;
import org.joml.Vector3d;

/** The eye and view of a player, in the space of the body's centre: the eye may already be beyond a portal. */
public final class PlayerEye {
    private PlayerEye() {}

    /** Sets {@code out} to the capsule's centre, which is the player's position. */
    public static Vector3d centre(PlayerState player, Vector3d out) {
        return set(player.centre(), out);
    }

    /** Sets {@code out} to the eye, as if no portal were between it and the centre. */
    public static Vector3d eye(PlayerState player, Vector3d out) {
        return set(player.eye(), out);
    }

    public static Basis view(PlayerState player) {
        return new PlayerView(player.heading(), player.tilt()).view();
    }

    public static Vector3d direction(Basis view, Vector3d out) {
        return out.set(-view.back().x(), -view.back().y(), -view.back().z());
    }

    private static Vector3d set(Vec3 v, Vector3d out) {
        return out.set(v.x(), v.y(), v.z());
    }
}
