package nephele.engine.collision;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The first face that a ray enters: clipping against the half spaces of each solid (Cyrus and Beck 1978). Only entering
 * counts, so a ray that starts on a face and leaves it does not see it, and one that starts inside a solid sees what
 * lies beyond; neither needs an offset. Reused for every query.
 */
public final class RayCast {
    /** A ray that starts this far behind a face, and goes in, started on it. */
    private static final double ON_SURFACE_METRES = 1e-9;

    /** Keeps 0 · ∞ out of the region that is searched. */
    private static final double FARTHEST_METRES = 1e9;

    private final CollisionWorld world;
    private final Region region = new Region();
    private final IndexList near = new IndexList();
    private final RoundedHull dot = RoundedHull.sphere(0);
    private final Vector3d way = new Vector3d();
    private final Vector3d normal = new Vector3d();
    private double distance;
    private int collider;
    private int face;

    public RayCast(CollisionWorld world) {
        this.world = world;
    }

    /** Metres to the hit. */
    public double distance() {
        return distance;
    }

    /** Index in the world of what was hit, −1 for nothing. */
    public int collider() {
        return collider;
    }

    /** Which of {@code collider.shape().faces()} was entered. */
    public int face() {
        return face;
    }

    /** Outward, unit length. */
    public Vector3dc normal() {
        return normal;
    }

    /** @param direction of unit length; true when something is hit within {@code range} metres */
    public boolean cast(Vector3dc from, Vector3dc direction, double range) {
        collider = -1;
        distance = range;
        if (!from.isFinite() || !direction.isFinite() || !(direction.lengthSquared() > 0)) {
            return false;
        }
        region.sweep(dot, from, direction.mul(Math.min(range, FARTHEST_METRES), way), ON_SURFACE_METRES);
        world.inside(region, near);
        for (int i = 0; i < near.size(); i++) {
            castAgainst(near.get(i), from, direction);
        }
        return collider >= 0;
    }

    private void castAgainst(int index, Vector3dc from, Vector3dc direction) {
        Collider solid = world.collider(index);
        double x = from.x() - solid.centre().x();
        double y = from.y() - solid.centre().y();
        double z = from.z() - solid.centre().z();
        double enter = Double.NEGATIVE_INFINITY;
        double leave = Double.POSITIVE_INFINITY;
        int entered = -1;
        for (int i = 0; i < solid.faces(); i++) {
            double rate = solid.plane(i, 0) * direction.x()
                    + solid.plane(i, 1) * direction.y()
                    + solid.plane(i, 2) * direction.z();
            double front = solid.inFrontOf(i, x, y, z);
            if (rate < 0) {
                if (-front / rate > enter) {
                    enter = -front / rate;
                    entered = i;
                }
            } else if (rate > 0) {
                leave = Math.min(leave, -front / rate);
            } else if (front > 0) {
                return;
            }
        }
        if (entered >= 0 && enter < leave && leave > 0 && enter < distance && startsOutside(solid, entered, x, y, z)) {
            collider = index;
            face = entered;
            distance = Math.max(0, enter);
            normal.set(solid.plane(entered, 0), solid.plane(entered, 1), solid.plane(entered, 2));
        }
    }

    private static boolean startsOutside(Collider solid, int entered, double x, double y, double z) {
        return solid.inFrontOf(entered, x, y, z) >= -ON_SURFACE_METRES;
    }
}
