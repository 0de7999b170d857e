package nephele.editor.transform;

import nephele.engine.math.Vec3;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/** A rotation about an axis through a pivot; quarter turns about an axis of the world are exact. */
record Turn(Vec3 pivot, Vec3 axis, double degrees) {
    Vec3 point(Vec3 p) {
        return pivot.plus(direction(p.minus(pivot)));
    }

    Vec3 direction(Vec3 v) {
        Vec3 turned = Vec3.of(rotation().transform(new Vector3d(v.x(), v.y(), v.z())));
        return degrees % 90 == 0 ? cleaned(turned) : turned;
    }

    /** Returns the size of the box around a box of this size after the turn. */
    Vec3 extent(Vec3 size) {
        Vec3 x = direction(new Vec3(size.x(), 0, 0));
        Vec3 y = direction(new Vec3(0, size.y(), 0));
        Vec3 z = direction(new Vec3(0, 0, size.z()));
        return new Vec3(
                Math.abs(x.x()) + Math.abs(y.x()) + Math.abs(z.x()),
                Math.abs(x.y()) + Math.abs(y.y()) + Math.abs(z.y()),
                Math.abs(x.z()) + Math.abs(y.z()) + Math.abs(z.z()));
    }

    /** Returns the change of a yaw angle: the turn, if its axis is vertical. */
    double yawDegrees() {
        return axis.x() == 0 && axis.z() == 0 ? Math.signum(axis.y()) * degrees : 0;
    }

    private Quaterniond rotation() {
        return new Quaterniond().fromAxisAngleDeg(axis.x(), axis.y(), axis.z(), degrees);
    }

    private static Vec3 cleaned(Vec3 v) {
        return new Vec3(cleaned(v.x()), cleaned(v.y()), cleaned(v.z()));
    }

    /** Removes the rounding of a quarter turn's sine and cosine. */
    private static double cleaned(double value) {
        return Math.rint(value * 0x1p30) * 0x1p-30 + 0.0;
    }
}
