package nephele.engine.math;

import org.joml.Vector3d;

/** Three doubles as a value: what immutable records hold. Arithmetic belongs to JOML's mutable {@link Vector3d}. */
public record Vec3(double x, double y, double z) {
    public static final Vec3 ZERO = new Vec3(0, 0, 0);

    /** A fresh mutable copy for calculations. */
    public Vector3d toVector() {
        return new Vector3d(x, y, z);
    }
}
