package nephele.engine.math;

/** Directions as values: what stays right where the textbook formula divides by zero or takes acos(1 + ε). */
public final class Directions {
    private Directions() {}

    /**
     * The unit vector along (x, y, z), also where its squares overflow or vanish; {@code null} for zero, infinite or NaN
     * components.
     */
    public static Vec3 unit(double x, double y, double z) {
        double largest = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        if (!(largest > 0 && largest <= Double.MAX_VALUE)) {
            return null;
        }
        // A power of two, so that scaling rounds nothing; in two steps, since it may itself overflow.
        int exponent = Math.getExponent(largest);
        double sx = Math.scalb(x, -exponent);
        double sy = Math.scalb(y, -exponent);
        double sz = Math.scalb(z, -exponent);
        double length = Math.sqrt(sx * sx + sy * sy + sz * sz);
        return new Vec3(sx / length, sy / length, sz / length);
    }

    public static double dot(Vec3 a, Vec3 b) {
        return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
    }

    public static Vec3 cross(Vec3 a, Vec3 b) {
        return new Vec3(a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x());
    }

    public static double length(Vec3 v) {
        return Math.sqrt(dot(v, v));
    }

    /** The angle between two directions in radians, exact for small ones: atan2 of sine and cosine, never acos. */
    public static double angle(Vec3 a, Vec3 b) {
        return StrictMath.atan2(length(cross(a, b)), dot(a, b));
    }

    /** The axis of the world that a unit vector is farthest from; z before y before x among equals, y up being usual. */
    public static Vec3 farthestAxis(Vec3 direction) {
        double x = Math.abs(direction.x());
        double y = Math.abs(direction.y());
        double z = Math.abs(direction.z());
        if (z <= x && z <= y) {
            return new Vec3(0, 0, 1);
        }
        return y <= x ? new Vec3(0, 1, 0) : new Vec3(1, 0, 0);
    }

    /** A unit vector perpendicular to a unit vector, always the same one. */
    public static Vec3 perpendicular(Vec3 direction) {
        Vec3 side = cross(farthestAxis(direction), direction);
        return unit(side.x(), side.y(), side.z());
    }

    /**
     * Turns unit vector {@code from} towards unit vector {@code to}. Opposite directions meet around the axis that
     * {@link #perpendicular} picks.
     *
     * @param share clamped to 0 … 1
     */
    public static Vec3 turned(Vec3 from, Vec3 to, double share) {
        double t = Double.isNaN(share) ? 0 : Math.max(0, Math.min(1, share));
        double angle = angle(from, to);
        if (angle < 1e-3) {
            return unit(
                    from.x() + t * (to.x() - from.x()),
                    from.y() + t * (to.y() - from.y()),
                    from.z() + t * (to.z() - from.z()));
        }
        Vec3 axis = cross(from, to);
        Vec3 unitAxis = length(axis) < 1e-9 ? perpendicular(from) : unit(axis.x(), axis.y(), axis.z());
        Vec3 side = cross(unitAxis, from);
        double cos = StrictMath.cos(t * angle);
        double sin = StrictMath.sin(t * angle);
        return unit(cos * from.x() + sin * side.x(), cos * from.y() + sin * side.y(), cos * from.z() + sin * side.z());
    }
}
