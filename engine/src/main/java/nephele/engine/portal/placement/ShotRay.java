package nephele.engine.portal.placement;

import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;

/**
 * From where a shot looks, and how the shooter holds the head: looking straight down, only that says what is ahead.
 *
 * @param view looks along −back; without roll its right is level
 */
public record ShotRay(Vec3 eye, Basis view) {
    /** Of unit length. */
    public Vec3 direction() {
        return view.back().negated();
    }
}
