package nephele.engine.math;

import org.joml.Quaterniond;
import org.joml.Quaterniondc;

/** Rotations as unit quaternions, by {@link StrictMath} only, so that the simulation can use them. */
public final class Rotations {
    /** Renormalising at least this often keeps the norm within 10⁻¹³ of 1. */
    public static final int STEPS_BETWEEN_RENORMALISATIONS = 1000;

    private static final double LERP_BELOW_RADIANS = 1e-3;

    private Rotations() {}

    /** Returns the rotation around an axis of any length; the identity for an axis of length zero. */
    public static Quaterniond aroundAxis(Vec3 axis, double radians) {
        Vec3 unit = Directions.unit(axis);
        if (unit == null || !Double.isFinite(radians)) {
            return new Quaterniond();
        }
        double sin = StrictMath.sin(radians / 2);
        return new Quaterniond(sin * unit.x(), sin * unit.y(), sin * unit.z(), StrictMath.cos(radians / 2));
    }

    /**
     * Returns the rotation that maps the world axes to three orthonormal axes, by the largest component (Shepperd 1978,
     * "Quaternion from Rotation Matrix").
     */
    public static Quaterniond ofAxes(Vec3 x, Vec3 y, Vec3 z) {
        double trace = x.x() + y.y() + z.z();
        if (trace >= Math.max(x.x(), Math.max(y.y(), z.z()))) {
            return normalised(new Quaterniond(y.z() - z.y(), z.x() - x.z(), x.y() - y.x(), 1 + trace));
        }
        if (x.x() >= y.y() && x.x() >= z.z()) {
            return normalised(new Quaterniond(1 + 2 * x.x() - trace, y.x() + x.y(), z.x() + x.z(), y.z() - z.y()));
        }
        if (y.y() >= z.z()) {
            return normalised(new Quaterniond(y.x() + x.y(), 1 + 2 * y.y() - trace, z.y() + y.z(), z.x() - x.z()));
        }
        return normalised(new Quaterniond(z.x() + x.z(), z.y() + y.z(), 1 + 2 * z.z() - trace, x.y() - y.x()));
    }

    /** Returns the quaternion scaled to length 1; the identity if its length is zero or not finite. */
    public static Quaterniond normalised(Quaterniondc q) {
        double largest =
                Math.max(Math.max(Math.abs(q.x()), Math.abs(q.y())), Math.max(Math.abs(q.z()), Math.abs(q.w())));
        if (!(largest > 0 && largest <= Double.MAX_VALUE)) {
            return new Quaterniond();
        }
        int exponent = Math.getExponent(largest);
        double x = Math.scalb(q.x(), -exponent);
        double y = Math.scalb(q.y(), -exponent);
        double z = Math.scalb(q.z(), -exponent);
        double w = Math.scalb(q.w(), -exponent);
        double length = Math.sqrt(x * x + y * y + z * z + w * w);
        return new Quaterniond(x / length, y / length, z / length, w / length);
    }

    /**
     * Interpolates two rotations along the shorter arc (Shoemake 1985, "Animating Rotation with Quaternion Curves",
     * section 3.3), with the angle from atan2. The shorter arc is at most a quarter turn of quaternion space, so no
     * pair is antipodal; for a half turn the signs given decide the direction.
     *
     * @param fraction clamped to 0 … 1
     */
    public static Quaterniond slerp(Quaterniondc from, Quaterniondc to, double fraction) {
        double t = Double.isNaN(fraction) ? 0 : Math.max(0, Math.min(1, fraction));
        Quaterniond a = normalised(from);
        Quaterniond b = normalised(to);
        if (dot(a, b) < 0) {
            b.set(-b.x, -b.y, -b.z, -b.w);
        }
        double angle = 2 * StrictMath.atan2(distance(a, b, -1), distance(a, b, 1));
        double weightA = 1 - t;
        double weightB = t;
        if (angle >= LERP_BELOW_RADIANS) {
            double sin = StrictMath.sin(angle);
            weightA = StrictMath.sin((1 - t) * angle) / sin;
            weightB = StrictMath.sin(t * angle) / sin;
        }
        return normalised(new Quaterniond(
                weightA * a.x + weightB * b.x,
                weightA * a.y + weightB * b.y,
                weightA * a.z + weightB * b.z,
                weightA * a.w + weightB * b.w));
    }

    private static double dot(Quaterniond a, Quaterniond b) {
        return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
    }

    /** Returns |a + sign · b|. */
    private static double distance(Quaterniond a, Quaterniond b, double sign) {
        double x = a.x + sign * b.x;
        double y = a.y + sign * b.y;
        double z = a.z + sign * b.z;
        double w = a.w + sign * b.w;
        return Math.sqrt(x * x + y * y + z * z + w * w);
    }
}
