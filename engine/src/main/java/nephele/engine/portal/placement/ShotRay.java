package nephele.engine.portal.placement;

import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;

/**
 * The ray of a shot and the shooter's view, which defines the direction ahead when looking straight down.
 *
 * @param view looks along −back; without roll its right is horizontal
 */
public record ShotRay(Vec3 eye, Basis view) {
    /** Returns the direction, of unit length. */
    public Vec3 direction() {
        return view.back().negated();
    }
}
