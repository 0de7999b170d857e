package nephele.engine.model.bound;

import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * A box with axes of any direction.
 *
 * @param x unit direction of its first axis
 * @param y unit direction of its second axis, perpendicular to the first
 * @param z unit direction of its third axis, perpendicular to both
 * @param half half its edges along its axes, metres
 */
public record OrientedBox(Vec3 centre, Vec3 x, Vec3 y, Vec3 z, Vec3 half) {
    /** Boxes closer than this share of their size touch, so that rounding separates none that do. */
    private static final double SLACK = 1e-9;

    public static OrientedBox of(Aabb local, Pose at) {
        var half = new Vec3(
                (local.maxX() - local.minX()) / 2,
                (local.maxY() - local.minY()) / 2,
                (local.maxZ() - local.minZ()) / 2);
        return new OrientedBox(at.moved(local.centre()), at.x(), at.y(), at.z(), half);
    }

    /** Returns the smallest box along the world's axes that contains this one. */
    public Aabb upright() {
        var size = new Vec3(
                Math.abs(x.x()) * half.x() + Math.abs(y.x()) * half.y() + Math.abs(z.x()) * half.z(),
                Math.abs(x.y()) * half.x() + Math.abs(y.y()) * half.y() + Math.abs(z.y()) * half.z(),
                Math.abs(x.z()) * half.x() + Math.abs(y.z()) * half.y() + Math.abs(z.z()) * half.z());
        return Aabb.around(centre, size.scaled(2 * (1 + SLACK)));
    }

    /**
     * Returns whether two boxes have a point in common: none of the fifteen axes that can separate boxes does
     * (Gottschalk, Lin and Manocha 1996, section 5).
     */
    boolean touches(OrientedBox other) {
        Vec3 between = other.centre.minus(centre);
        double slack = SLACK * (half.length() + other.half.length());
        Vec3[] own = {x, y, z};
        Vec3[] others = {other.x, other.y, other.z};
        for (int i = 0; i < 3; i++) {
            if (isApart(own[i], between, other, slack) || isApart(others[i], between, other, slack)) {
                return false;
            }
        }
        for (Vec3 a : own) {
            for (Vec3 b : others) {
                if (isApart(a.cross(b), between, other, slack)) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Returns whether an axis separates the boxes; an axis of no length separates nothing. */
    private boolean isApart(Vec3 axis, Vec3 between, OrientedBox other, double slack) {
        return Math.abs(between.dot(axis)) > reach(axis) + other.reach(axis) + slack;
    }

    private double reach(Vec3 axis) {
        return half.x() * Math.abs(x.dot(axis)) + half.y() * Math.abs(y.dot(axis)) + half.z() * Math.abs(z.dot(axis));
    }
}
