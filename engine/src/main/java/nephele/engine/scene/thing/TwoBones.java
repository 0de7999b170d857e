package nephele.engine.scene.thing;

import org.joml.Matrix3d;
import org.joml.Vector3d;

/** A limb of two bones: where it bends, by the law of cosines, and how its bones are turned. One object serves all limbs. */
final class TwoBones {
    /** The joint between the bones. */
    final Vector3d middle = new Vector3d();
    /** Where the limb ends: as near to where it is to reach as it can. */
    final Vector3d end = new Vector3d();
    /** Towards where the limb bends, in front of it. */
    final Vector3d bend = new Vector3d();

    private final Vector3d along = new Vector3d();
    private final Vector3d across = new Vector3d();
    private final Vector3d back = new Vector3d();
    private final Vector3d between = new Vector3d();

    /** Puts {@link #middle} where two bones from {@code from} to {@code to} bend, and {@link #end} where they end. */
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

    /** Writes how a bone is turned that hangs from one joint to the other, a leg's front where it bends. */
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

    /** A bone's middle, valid until the next call. */
    Vector3d between(Vector3d from, Vector3d to) {
        return between.set(from).lerp(to, 0.5);
    }
}
