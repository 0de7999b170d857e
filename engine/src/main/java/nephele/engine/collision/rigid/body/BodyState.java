package nephele.engine.collision.rigid.body;

import nephele.engine.math.Vec3;
import org.joml.Quaterniond;

/**
 * The motion of one body, as a value.
 *
 * @param centre of mass, world
 * @param orientation world from body, unit length; must not be changed
 * @param velocity of the centre, m/s
 * @param spin angular velocity in world axes, rad/s
 */
public record BodyState(Vec3 centre, Quaterniond orientation, Vec3 velocity, Vec3 spin) {
    /** Returns an upright body at rest. */
    public static BodyState resting(Vec3 centre) {
        return new BodyState(centre, new Quaterniond(), Vec3.ZERO, Vec3.ZERO);
    }

    /** Returns this place and orientation with another velocity (m/s) and angular velocity (rad/s). */
    public BodyState moving(Vec3 newVelocity, Vec3 newSpin) {
        return new BodyState(centre, orientation, newVelocity, newSpin);
    }
}
