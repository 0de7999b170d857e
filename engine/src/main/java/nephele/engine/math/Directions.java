package nephele.engine.math;

/** Vector arithmetic on immutable vectors, robust where textbook formulas divide by zero or evaluate acos(1 + ε). */
public final class Directions {
    private Directions() {}

    /**
     * Returns the unit vector along (x, y, z), even if its squares overflow or underflow; {@code null} for zero,
     * infinite or NaN components.
     */
    public static Vec3 unit(double x, double y, double z) {
        double largest = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        if (!(largest > 0 && largest <= Double.MAX_VALUE)) {
            return null;
        }
        // Scaling by a power of two is exact.
        int exponent = Math.getExponent(largest);
        double sx = Math.scalb(x, -exponent);
        double sy = Math.scalb(y, -exponent);
        double sz = Math.scalb(z, -exponent);
        double length = Math.sqrt(sx * sx + sy * sy + sz * sz);
        return new Vec3(sx / length, sy / length, sz / length);
    }

    /** Returns the unit vector along {@code v}, or {@code null}, as {@link #unit(double, double, double)}. */
    public static Vec3 unit(Vec3 v) {
        return unit(v.x(), v.y(), v.z());
    }

    /** Returns {@code ofA} · {@code a} + {@code ofB} · {@code b}. */
    public static Vec3 combined(Vec3 a, double ofA, Vec3 b, double ofB) {
        return new Vec3(ofA * a.x() + ofB * b.x(), ofA * a.y() + ofB * b.y(), ofA * a.z() + ofB * b.z());
    }

    /**
     * Returns the angle between two directions in radians, accurate for small angles: atan2 of sine and cosine, not
     * acos.
     */
    public static double angle(Vec3 a, Vec3 b) {
        return StrictMath.atan2(a.cross(b).length(), a.dot(b));
    }

    /** Returns the world axis farthest from a unit vector; ties prefer z, then y, because up is usually y. */
    public static Vec3 farthestAxis(Vec3 direction) {
        double x = Math.abs(direction.x());
        double y = Math.abs(direction.y());
        double z = Math.abs(direction.z());
        if (z <= x && z <= y) {
            return new Vec3(0, 0, 1);
        }
        return y <= x ? new Vec3(0, 1, 0) : new Vec3(1, 0, 0);
    }

    /** Returns a unit vector perpendicular to a unit vector; deterministic. */
    public static Vec3 perpendicular(Vec3 direction) {
        Vec3 side = farthestAxis(direction).cross(direction);
        return unit(side);
    }

    /**
     * Rotates unit vector {@code from} towards unit vector {@code to}. Opposite directions rotate around the axis that
     * {@link #perpendicular} returns.
     *
     * @param fraction of the angle, clamped to 0 … 1
     */
    public static Vec3 slerp(Vec3 from, Vec3 to, double fraction) {
        double t = Double.isNaN(fraction) ? 0 : Math.max(0, Math.min(1, fraction));
        double angle = angle(from, to);
        if (angle < 1e-3) {
            return unit(from.lerp(to, t));
        }
        Vec3 axis = from.cross(to);
        Vec3 unitAxis = axis.length() < 1e-9 ? perpendicular(from) : unit(axis);
        Vec3 side = unitAxis.cross(from);
        double cos = StrictMath.cos(t * angle);
        double sin = StrictMath.sin(t * angle);
        return unit(combined(from, cos, side, sin));
    }
}
