package nephele.engine.portal.placement;

import nephele.engine.math.Vec3;

/** The obstacles of a shot that are not static geometry. */
@FunctionalInterface
public interface MovingSurfaces {
    /** No obstacles. */
    MovingSurfaces NONE = (eye, direction, limitMetres) -> Double.POSITIVE_INFINITY;

    /**
     * Returns the distance in metres along the unit {@code direction} to the first of them; any value beyond the limit
     * if there is none before it.
     */
    double distance(Vec3 eye, Vec3 direction, double limitMetres);
}
