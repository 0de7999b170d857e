package nephele.engine.sim;

import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/** The eye and view of a player, in the space of the body's centre: the eye may already be beyond a portal. */
final class PlayerEye {
    private PlayerEye() {}

    /** Sets {@code out} to the capsule's centre, which is the player's position. */
    static Vector3d centre(PlayerState player, Vector3d out) {
        return set(player.centre(), out);
    }

    /** Sets {@code out} to the eye, as if no portal were between it and the centre. */
    static Vector3d eye(PlayerState player, Vector3d out) {
        return set(player.eye(), out);
    }

    static Basis view(PlayerState player) {
        return new Look(player.heading(), player.tilt()).view();
    }

    static Vector3d direction(Basis view, Vector3d out) {
        return out.set(-view.back().x(), -view.back().y(), -view.back().z());
    }

    private static Vector3d set(Vec3 v, Vector3d out) {
        return out.set(v.x(), v.y(), v.z());
    }
}
