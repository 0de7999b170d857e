package nephele.engine.scene.dynamic;

import org.joml.Matrix3d;
import org.joml.Vector3d;

/**
 * A limb of two bones: the position of its joint, by the law of cosines, and the orientations of its bones. One object
 * serves all limbs.
 */
final class TwoBoneIk {
    /** The joint between the bones. */
    final Vector3d middle = new Vector3d();
    /** The end of the limb: the reachable point nearest to the target. */
    final Vector3d end = new Vector3d();
    /** The direction towards which the limb bends; set it before {@link #bend(Vector3d, Vector3d, double, double)}. */
    final Vector3d bend = new Vector3d();

    private final Vector3d along = new Vector3d();
    private final Vector3d across = new Vector3d();
    private final Vector3d back = new Vector3d();
    private final Vector3d between = new Vector3d();

    /** Computes {@link #middle} and {@link #end} for a limb from {@code from} towards {@code to}; lengths in metres. */
    void bend(Vector3d from, Vector3d to, double upper, double lower) {
        along.set(to).sub(from);
        double distance = Math.max(Math.abs(upper - lower) + 0.05, Math.min(upper + lower - 0.002, along.length()));
        if (along.length() < 1e-6) {
            along.set(0, -1, 0);
        }
        along.normalize();
        end.set(from).fma(distance, along);
        bend.fma(-bend.dot(along), along);
        if (bend.length() < 1e-6) {
            bend.set(0, 0, -1).fma(along.z, along);
        }
        bend.normalize();
        double before = (upper * upper - lower * lower + distance * distance) / (2 * distance);
        double aside = Math.sqrt(Math.max(0, upper * upper - before * before));
        middle.set(from).fma(before, along).fma(aside, bend);
    }

    /** Computes the rotation of a bone from one joint down to the other; a leg's front is on the side of the bend. */
    void along(Vector3d from, Vector3d to, boolean isLeg, Matrix3d turn) {
        Vector3d y = along.set(from).sub(to).normalize();
        Vector3d z = back.set(bend).mul(isLeg ? -1 : 1);
        z.fma(-z.dot(y), y);
        if (z.length() < 1e-6) {
            z.set(0, 0, 1).fma(-y.z, y);
        }
        z.normalize();
        Vector3d x = y.cross(z, across);
        turn.set(x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z);
    }

    /** Returns a bone's middle, valid until the next call. */
    Vector3d between(Vector3d from, Vector3d to) {
        return between.set(from).lerp(to, 0.5);
    }
}
