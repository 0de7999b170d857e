package nephele.engine.collision;

import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Signed distance between a moving shape and a collider or another moving shape, with the direction that increases it:
 * by {@link Gjk} while their cores are apart, by {@link SeparatingAxes} when they overlap. Reused for every query.
 */
public final class Separation {
    private final Gjk gjk = new Gjk();
    private final SeparatingAxes axes = new SeparatingAxes();
    private Collider collider;
    private boolean overlapping;
    private double metres;
    private final Vector3d normal = new Vector3d();

    /**
     * Returns the signed distance, negative when the shape overlaps the collider; outside overlapping cores never more
     * than the true one.
     */
    public double metres() {
        return metres;
    }

    /** Returns the unit vector from the collider towards the shape. */
    public Vector3dc normal() {
        return normal;
    }

    /** Returns by how much the distance shrinks along a displacement, to first order. */
    public double approach(Vector3dc displacement) {
        return -(normal.x * displacement.x() + normal.y * displacement.y() + normal.z * displacement.z());
    }

    /**
     * Returns a world coordinate of the collider's nearest point along an axis (0, 1, 2); valid while the shape's core
     * is outside.
     */
    public double onCollider(int axis) {
        Vec3 centre = collider.centre();
        double origin = axis == 0 ? centre.x() : axis == 1 ? centre.y() : centre.z();
        return origin + (overlapping ? 0 : gjk.onCollider(collider, axis) + collider.radiusMetres() * normal.get(axis));
    }

    /**
     * Returns the face that contains the nearest point, of several the one with the most upward normal; −1 for none.
     */
    int upmostFace(double toleranceMetres) {
        if (overlapping) {
            return -1;
        }
        double x = gjk.onCollider(collider, 0);
        double y = gjk.onCollider(collider, 1);
        double z = gjk.onCollider(collider, 2);
        int best = -1;
        for (int face = 0; face < collider.faces(); face++) {
            if (Math.abs(collider.inFrontOf(face, x, y, z)) <= toleranceMetres
                    && (best < 0 || collider.plane(face, 1) > collider.plane(best, 1))) {
                best = face;
            }
        }
        return best;
    }

    /** Measures a shape with its origin at x, y, z in the world. */
    public void measure(RoundedHull shape, double x, double y, double z, Collider against) {
        collider = against;
        double localX = x - against.centre().x();
        double localY = y - against.centre().y();
        double localZ = z - against.centre().z();
        gjk.measure(shape, localX, localY, localZ, against);
        overlapping = !(gjk.distance() > 0);
        if (overlapping) {
            axes.measure(shape, localX, localY, localZ, against);
            metres = axes.distance();
            normal.set(axes.normal());
        } else {
            metres = gjk.distance();
            normal.set(gjk.normal());
        }
        metres -= shape.radiusMetres() + against.radiusMetres();
    }

    /**
     * Measures two rounded shapes. When their cores overlap, the depth is unknown: the result is then minus the sum of
     * the radii, along the line between the centres. There is no nearest point and no face of such a pair.
     *
     * @param x coordinate of the first shape's origin relative to the second's; likewise y and z
     */
    public void measure(RoundedHull first, double x, double y, double z, RoundedHull second) {
        gjk.measure(first, x, y, z, second);
        double radii = first.radiusMetres() + second.radiusMetres();
        if (gjk.distance() > 0) {
            metres = gjk.distance() - radii;
            normal.set(gjk.normal());
            return;
        }
        double length = Math.sqrt(x * x + y * y + z * z);
        metres = -radii;
        normal.set(length > 0 ? x / length : 0, length > 0 ? y / length : 1, length > 0 ? z / length : 0);
    }
}
