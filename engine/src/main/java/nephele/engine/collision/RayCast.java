package nephele.engine.collision;

import nephele.engine.math.Ray;
import nephele.engine.math.bvh.RayHit;

/**
 * The first face that a ray enters: clipping against the half spaces of each solid (Cyrus and Beck 1978). Only entering
 * counts: a ray that starts on a face and leaves it does not hit it, and one that starts inside a solid hits what is
 * beyond, both without an offset. Reused for every query.
 */
public final class RayCast {
    /** Depth behind a face up to which a ray that enters it counts as starting on it. */
    private static final double ON_SURFACE_METRES = 1e-9;

    private CollisionWorld world;
    private final RayHit hit = new RayHit();
    private int entered;
    private double entry;

    /** Returns the ray parameter of the hit: metres for a direction of unit length. */
    public double distance() {
        return hit.distance();
    }

    /** Returns the index of the solid that was hit in the world of the query, −1 for none. */
    public int collider() {
        return hit.item();
    }

    /** Returns true if something is hit up to the ray parameter {@code limit}. */
    public boolean cast(CollisionWorld in, Ray ray, double limit) {
        world = in;
        return in.nearest(ray, limit, (r, item, most) -> in.entry(r, item, this), hit);
    }

    /** Returns the index in {@code shape().faces()} of the face that the ray entered, of the solid that was hit. */
    public int face(Ray ray) {
        entered = 0;
        world.entry(ray, hit.item(), this);
        return entered;
    }

    /** Returns the ray parameter at which the solid is entered, at least 0; infinity for a miss. */
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
