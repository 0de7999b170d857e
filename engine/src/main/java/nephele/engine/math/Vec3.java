package nephele.engine.math;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * An immutable vector of three doubles with the arithmetic of values. Loops that must not allocate use JOML's mutable
 * {@link Vector3d}; {@link Directions} holds what needs care near zero, overflow and parallel vectors.
 */
public record Vec3(double x, double y, double z) {
    public static final Vec3 ZERO = new Vec3(0, 0, 0);

    /** Returns an immutable copy. */
    public static Vec3 of(Vector3dc v) {
        return new Vec3(v.x(), v.y(), v.z());
    }

    /** Returns −v. */
    public Vec3 negated() {
        return new Vec3(-x, -y, -z);
    }

    public Vec3 plus(Vec3 v) {
        return new Vec3(x + v.x, y + v.y, z + v.z);
    }

    /** Returns this − {@code v}: the vector from {@code v} to this point. */
    public Vec3 minus(Vec3 v) {
        return new Vec3(x - v.x, y - v.y, z - v.z);
    }

    /** Returns factor · v. */
    public Vec3 scaled(double factor) {
        return new Vec3(x * factor, y * factor, z * factor);
    }

    /** Returns the products of the components. */
    public Vec3 times(Vec3 v) {
        return new Vec3(x * v.x, y * v.y, z * v.z);
    }

    /** Returns this + {@code factor} · {@code v}. */
    public Vec3 addScaled(double factor, Vec3 v) {
        return new Vec3(x + factor * v.x, y + factor * v.y, z + factor * v.z);
    }

    /** Returns this + {@code fraction} · ({@code to} − this): the linear interpolation from this to {@code to}. */
    public Vec3 lerp(Vec3 to, double fraction) {
        return new Vec3(x + (to.x - x) * fraction, y + (to.y - y) * fraction, z + (to.z - z) * fraction);
    }

    /** Returns the dot product. */
    public double dot(Vec3 v) {
        return x * v.x + y * v.y + z * v.z;
    }

    /** Returns the cross product, this × v. */
    public Vec3 cross(Vec3 v) {
        return new Vec3(y * v.z - z * v.y, z * v.x - x * v.z, x * v.y - y * v.x);
    }

    /** Returns the Euclidean length. */
    public double length() {
        return Math.sqrt(dot(this));
    }

    /** Writes a row in the layout of shaders: three floats at {@code at}, followed by a fourth number. */
    public void put(float[] rows, int at, double fourth) {
        rows[at] = (float) x;
        rows[at + 1] = (float) y;
        rows[at + 2] = (float) z;
        rows[at + 3] = (float) fourth;
    }

    /** Returns a new mutable copy for calculations. */
    public Vector3d toVector() {
        return new Vector3d(x, y, z);
    }
}
