package nephele.scenes.xml;

import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.model.CatmullRom;
import org.joml.Matrix4d;
import org.joml.Vector3d;

/** The frame of an object on a closed curve; depends only on the time. Allocates nothing after construction. */
final class CurveFrame {
    /** Sine below which a direction counts as vertical. */
    private static final double PARALLEL = 1e-9;

    private final CatmullRom curve;
    private final Vector3d ahead = new Vector3d();
    private final Vector3d side = new Vector3d();
    private final Vector3d upright = new Vector3d();

    CurveFrame(List<Vec3> through) {
        curve = new CatmullRom(through);
    }

    /** Multiplies a frame by one whose origin is on the curve and whose axes stay. */
    void carry(double round, Matrix4d frame) {
        curve.position(round, ahead);
        frame.translate(ahead);
    }

    /**
     * Moves a frame as {@link #carry} does, with x along the curve, z = x × (0, 1, 0) and y = z × x. Where the curve is
     * vertical, z is (0, 0, 1); where its derivative is zero, x is its initial direction, and a curve of one point
     * rotates nothing.
     */
    void carryAligned(double round, Matrix4d frame, Matrix4d axes) {
        carry(round, frame);
        curve.derivative(round, ahead);
        if (ahead.lengthSquared() == 0) {
            curve.secondDerivative(round, ahead);
        }
        if (ahead.lengthSquared() == 0) {
            return;
        }
        ahead.normalize();
        side.set(-ahead.z, 0, ahead.x);
        if (side.length() < PARALLEL) {
            side.set(0, 0, 1);
        }
        side.normalize();
        side.cross(ahead, upright).normalize();
        // If up is not exactly perpendicular, neither is the side.
        ahead.cross(upright, side);
        axes.set(
                ahead.x, ahead.y, ahead.z, 0, upright.x, upright.y, upright.z, 0, side.x, side.y, side.z, 0, 0, 0, 0,
                1);
        frame.mul(axes);
    }
}
