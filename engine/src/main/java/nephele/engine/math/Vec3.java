package nephele.engine.math;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** An immutable vector of three doubles for use in records. Use JOML's mutable {@link Vector3d} for arithmetic. */
public record Vec3(double x, double y, double z) {
    public static final Vec3 ZERO = new Vec3(0, 0, 0);

    /** Returns an immutable copy. */
    public static Vec3 of(Vector3dc v) {
        return new Vec3(v.x(), v.y(), v.z());
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
