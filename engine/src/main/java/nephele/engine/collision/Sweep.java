package nephele.engine.collision;

import nephele.engine.math.bvh.ItemList;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Moves a shape along a straight line until it is {@link #SKIN_METRES} from the first solid. The accessors describe the
 * last query. Reused for every query.
 *
 * <p>The distance to a convex solid is a convex function of the distance travelled, and Gjk gives a tangent below it.
 * So Newton's method from the near side never passes the first root: no speed tunnels through any thickness
 * (conservative advancement, Mirtich 1996; van den Bergen 2004).
 */
public final class Sweep {
    /** Distance at which the shape rests from what it touches. */
    public static final double SKIN_METRES = 1e-3;

    /** The difference to the wanted distance that counts as reached. */
    public static final double TOUCH_METRES = 1e-8;

    private static final int MAX_STEPS = 64;
    /** Approach per metre travelled below which the shape is sliding: the rounding error of a tangent direction. */
    public static final double SLIDING_METRES_PER_METRE = 1e-9;

    private static final double SAME_POINT_METRES = 1e-6;

    private CollisionWorld world;
    private final Separation separation = new Separation();
    private final ItemList near = new ItemList();
    private final Vector3d normal = new Vector3d();
    private final Vector3d point = new Vector3d();
    private final Vector3d upmostNormal = new Vector3d();
    private double fraction;
    private int collider;

    /** Returns the free fraction of the displacement, 0 to 1. */
    public double fraction() {
        return fraction;
    }

    /** Returns the unit normal of the surface that was hit, towards the shape. */
    public Vector3dc normal() {
        return normal;
    }

    /** Returns the point where the solid was hit. */
    public Vector3dc point() {
        return point;
    }

    /** Returns the index of the solid that was hit in the world of the query, −1 for none. */
    public int collider() {
        return collider;
    }

    /** Returns the outward normal of the most upward face at the point: the tread at a stair's edge. */
    public Vector3dc upmostNormal() {
        return upmostNormal;
    }

    /** Returns true if a solid blocks the displacement. Solids that the shape leaves or slides along do not. */
    public boolean cast(CollisionWorld in, RoundedHull shape, Vector3dc from, Vector3dc displacement) {
        world = in;
        fraction = 1;
        collider = -1;
        double length = displacement.length();
        if (!(length > 0)) {
            return false;
        }
        world.near(shape, from, displacement, 2 * SKIN_METRES, near);
        for (int i = 0; i < near.size(); i++) {
            castAgainst(near.get(i), shape, from, displacement, length);
        }
        return collider >= 0;
    }

    private void castAgainst(int index, RoundedHull shape, Vector3dc from, Vector3dc path, double length) {
        Collider solid = world.collider(index);
        double t = 0;
        for (int i = 0; i < MAX_STEPS; i++) {
            separation.measure(shape, from.x() + t * path.x(), from.y() + t * path.y(), from.z() + t * path.z(), solid);
            double approach = separation.approach(path);
            double gap = separation.metres() - SKIN_METRES;
            if (approach <= (gap <= TOUCH_METRES ? SLIDING_METRES_PER_METRE * length : 0)) {
                return;
            }
            if (gap <= TOUCH_METRES || i == MAX_STEPS - 1) {
                keep(index, solid, t);
                return;
            }
            t += gap / approach;
            if (!(t < fraction)) {
                return;
            }
        }
    }

    private void keep(int index, Collider solid, double t) {
        // Several solids may be touched at the start: the lowest index is kept, the others are found by the next slide.
        if (collider >= 0 && t >= fraction) {
            return;
        }
        fraction = t;
        collider = index;
        normal.set(separation.normal());
        point.set(separation.onCollider(0), separation.onCollider(1), separation.onCollider(2));
        int face = separation.upmostFace(SAME_POINT_METRES);
        if (face >= 0) {
            upmostNormal.set(solid.plane(face, 0), solid.plane(face, 1), solid.plane(face, 2));
        } else {
            upmostNormal.set(normal);
        }
    }
}
