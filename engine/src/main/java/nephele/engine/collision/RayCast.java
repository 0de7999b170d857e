package nephele.engine.collision;

import nephele.engine.math.Ray;
import nephele.engine.math.RayHit;

/**
 * The first face that a ray enters: clipping against the half spaces of each solid (Cyrus and Beck 1978). Only entering
 * counts, so a ray that starts on a face and leaves it does not see it, and one that starts inside a solid sees what
 * lies beyond; neither needs an offset. Reused for every query.
 */
public final class RayCast {
    /** A ray that starts this far behind a face, and goes in, started on it. */
    private static final double ON_SURFACE_METRES = 1e-9;

    private CollisionWorld world;
    private final RayHit hit = new RayHit();
    private int entered;
    private double entry;

    /** The ray parameter of the hit: metres for a direction of unit length. */
    public double distance() {
        return hit.distance();
    }

    /** Index in the world that was asked of what was hit, −1 for nothing. */
    public int collider() {
        return hit.item();
    }

    /** True when something is hit up to the ray parameter {@code limit}. */
    public boolean cast(CollisionWorld in, Ray ray, double limit) {
        world = in;
        return in.nearest(ray, limit, (r, item, most) -> in.entry(r, item, this), hit);
    }

    /** Which of {@code shape().faces()} of the solid that was hit the ray entered. */
    public int face(Ray ray) {
        entered = 0;
        world.entry(ray, hit.item(), this);
        return entered;
    }

    /** The ray parameter at which the solid is entered, at least 0; infinity for a miss. */
    double entry(Ray ray, Collider solid) {
        double x = ray.originX() - solid.centre().x();
        double y = ray.originY() - solid.centre().y();
        double z = ray.originZ() - solid.centre().z();
        double leave = Double.POSITIVE_INFINITY;
        entry = Double.NEGATIVE_INFINITY;
        entered = -1;
        for (int i = 0; i < solid.faces(); i++) {
            double rate = solid.plane(i, 0) * ray.directionX()
                    + solid.plane(i, 1) * ray.directionY()
                    + solid.plane(i, 2) * ray.directionZ();
            double front = solid.inFrontOf(i, x, y, z);
            if (rate < 0) {
                if (-front / rate > entry) {
                    entry = -front / rate;
                    entered = i;
                }
            } else if (rate > 0) {
                leave = Math.min(leave, -front / rate);
            } else if (front > 0) {
                return Double.POSITIVE_INFINITY;
            }
        }
        boolean hits = entered >= 0 && entry < leave;
        return hits && solid.inFrontOf(entered, x, y, z) >= -ON_SURFACE_METRES
                ? Math.max(0, entry)
                : Double.POSITIVE_INFINITY;
    }
}
