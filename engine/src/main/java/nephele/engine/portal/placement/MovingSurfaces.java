package nephele.engine.portal.placement;

import nephele.engine.math.Vec3;

/** Everything that stops a shot and is no part of the level's fixed solids. */
@FunctionalInterface
public interface MovingSurfaces {
    /** Nothing moves. */
    MovingSurfaces NONE = (eye, direction, limitMetres) -> Double.POSITIVE_INFINITY;

    /** Metres along the unit {@code direction} to the first of them; anything beyond the limit for none before it. */
    double distance(Vec3 eye, Vec3 direction, double limitMetres);
}
