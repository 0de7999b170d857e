package nephele.engine.reference;

import nephele.engine.math.Ray;
import org.joml.Vector3dc;

/** Tests shadow rays. Use one per thread. */
final class ShadowRays {
    private final TracedItems surfaces;
    private final Shafts shafts;
    private final Ray ray = Ray.reusable();
    private Shafts.Cube cube;

    ShadowRays(TracedItems surfaces, Shafts shafts) {
        this.surfaces = surfaces;
        this.shafts = shafts;
    }

    /**
     * Returns true if light is blocked.
     *
     * @param light number of the sun or of a punctual light in {@code direction}
     * @param limit parameter of the ray up to which items block it
     * @param lit the lit item: a convex item does not shade itself
     */
    boolean isBlocked(int light, Vector3dc origin, Vector3dc direction, double limit, int lit) {
        int except = surfaces.withoutOwnShade(lit);
        ray.aim(origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z());
        cube = shafts.cube(origin, cube);
        return cube == null
                ? surfaces.blocker(ray, limit, except) >= 0
                : shafts.shaft(cube, light).isBlocked(ray, limit, except);
    }

    /** Returns true if the sky is occluded in a direction. */
    boolean isSkyBlocked(Vector3dc origin, Vector3dc direction, int lit) {
        return isBlocked(shafts.patch(direction), origin, direction, Double.POSITIVE_INFINITY, lit);
    }
}
