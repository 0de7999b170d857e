package nephele.engine.sim.player;

import static nephele.engine.sim.state.PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED;
import static nephele.engine.sim.state.PlayerDimensions.MIN_GROUND_NORMAL_Y;

import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerInput;
import org.joml.Vector3d;

/**
 * Moves a player in the air: along an exact ballistic arc, sliding along obstacles, landing, and crossing portals at
 * the exact time.
 */
final class AirFlight {
    private final CharacterMover mover;
    private final GroundWalk walk;
    private final Vector3d displacement = new Vector3d();
    private final Vector3d acceleration = new Vector3d();

    AirFlight(CharacterMover mover, GroundWalk walk) {
        this.mover = mover;
        this.walk = walk;
    }

    /** Flies for a tick. The arc is cut at each portal entry and continues from the exit with the remaining time. */
    void fly(PlayerMotion player, PlayerInput input, double seconds) {
        double left = seconds;
        for (int i = 0; player.hasPortals() && i <= 2 * PlayerMotion.MOST_HOPS; i++) {
            player.intend(input);
            accelerate(player, left);
            double t = player.timeToEntry(acceleration, left);
            if (player.hasDroppedTime()) {
                return;
            }
            if (t >= left) {
                break;
            }
            boolean met = flyFor(player, t);
            if (met) {
                player.crossPortals();
            } else {
                player.enterFound();
            }
            left -= t;
            if (player.grounded || player.hasDroppedTime()) {
                return;
            }
        }
        player.intend(input);
        if (!flyFor(player, left)) {
            land(player, displacement.y);
        }
        player.crossPortals();
    }

    /**
     * Moves along the exact ballistic displacement v t − g t² / 2 (velocity Verlet under constant acceleration).
     * Returns true if a surface was hit.
     */
    private boolean flyFor(PlayerMotion player, double seconds) {
        Vector3d velocity = player.velocity;
        displacement.set(velocity).mul(seconds);
        steer(player, seconds);
        displacement.y -= GRAVITY_METRES_PER_SECOND_SQUARED * seconds * seconds / 2;
        velocity.y -= GRAVITY_METRES_PER_SECOND_SQUARED * seconds;
        double fall = displacement.y;
        double heightBefore = player.place.y;
        double vX = velocity.x;
        double vZ = velocity.z;
        mover.slide(player.shape(), player.place, displacement);
        if (mover.planes().size() == 0) {
            return false;
        }
        mover.pushes().intent(velocity);
        mover.planes().removeComponentsInto(velocity);
        boolean wedged = fall < 0 && mover.planes().size() >= 2 && player.place.y - heightBefore > fall / 100;
        if (fall < 0 && walk.land(player.shape(), player.place)) {
            touchDown(player, vX, vZ);
        } else if (wedged) {
            player.ground.set(0, 1, 0);
            player.grounded = true;
            velocity.y = 0;
        }
        return true;
    }

    /** Lands the player if ground is within touching distance after a flight without a hit. */
    private void land(PlayerMotion player, double fall) {
        if (fall < 0 && walk.land(player.shape(), player.place)) {
            touchDown(player, player.velocity.x, player.velocity.z);
        }
    }

    /**
     * Keeps the horizontal speed on landing, as a walkable slope does not push. Only the parts of the velocity into
     * steep surfaces hit in the same tick are removed.
     */
    private void touchDown(PlayerMotion player, double vX, double vZ) {
        Vector3d velocity = player.velocity;
        player.grounded = true;
        player.ground.set(walk.ground());
        velocity.set(vX, 0, vZ);
        for (int i = 0; i < mover.planes().size(); i++) {
            double into = velocity.dot(mover.planes().normal(i));
            if (mover.planes().normal(i).y() < MIN_GROUND_NORMAL_Y && into < 0) {
                velocity.sub(displacement.set(mover.planes().normal(i)).mul(into));
            }
        }
        velocity.y = 0;
    }

    /** Sets the acceleration to gravity plus the mean acceleration of steering over {@code seconds}. */
    private void accelerate(PlayerMotion player, double seconds) {
        double vX = player.velocity.x;
        double vZ = player.velocity.z;
        steer(player, seconds);
        acceleration.set(
                (player.velocity.x - vX) / seconds,
                -GRAVITY_METRES_PER_SECOND_SQUARED,
                (player.velocity.z - vZ) / seconds);
        player.velocity.x = vX;
        player.velocity.z = vZ;
    }

    /**
     * Accelerates along the move intent up to its speed. The result is no faster than the greater of the present and
     * the intended speed; without intent the velocity stays.
     */
    private void steer(PlayerMotion player, double seconds) {
        Vector3d velocity = player.velocity;
        Vector3d intent = player.intent;
        double wished = intent.length();
        if (wished == 0) {
            return;
        }
        double along = (velocity.x * intent.x + velocity.z * intent.z) / wished;
        double gain = Math.min(PlayerDimensions.AIR_METRES_PER_SECOND_SQUARED * seconds, wished - along);
        if (gain <= 0) {
            return;
        }
        double before = Math.sqrt(velocity.x * velocity.x + velocity.z * velocity.z);
        double x = velocity.x + intent.x / wished * gain;
        double z = velocity.z + intent.z / wished * gain;
        double limit = Math.max(before, wished);
        double scale = Math.min(1, limit / Math.sqrt(x * x + z * z));
        displacement.x += (x * scale - velocity.x) * seconds / 2;
        displacement.z += (z * scale - velocity.z) * seconds / 2;
        velocity.x = x * scale;
        velocity.z = z * scale;
    }
}
