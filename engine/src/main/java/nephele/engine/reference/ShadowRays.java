package nephele.engine.reference;

import nephele.engine.math.Ray;
import org.joml.Vector3dc;

/** Asks whether light arrives. One for each thread. */
final class ShadowRays {
    private final SurfaceRays surfaces;
    private final Beams beams;
    private final Ray ray = Ray.reusable();
    private Beams.Cube cube;

    ShadowRays(SurfaceRays surfaces, Beams beams) {
        this.surfaces = surfaces;
        this.beams = beams;
    }

    /**
     * @param light number of the sun or a lamp, which lies in {@code direction}
     * @param limit parameter of the ray up to which something is in the way
     * @param lit the item that is lit: a convex thing does not shade itself
     */
    boolean isBlocked(int light, Vector3dc origin, Vector3dc direction, double limit, int lit) {
        int except = surfaces.withoutOwnShade(lit);
        ray.aim(origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z());
        cube = beams.cube(origin, cube);
        return cube == null
                ? surfaces.blocker(ray, limit, except) >= 0
                : beams.beam(cube, light).isBlocked(ray, limit, except);
    }

    /** Whether the sky is out of sight in a direction. */
    boolean isSkyBlocked(Vector3dc origin, Vector3dc direction, int lit) {
        return isBlocked(beams.patch(direction), origin, direction, Double.POSITIVE_INFINITY, lit);
    }
}
