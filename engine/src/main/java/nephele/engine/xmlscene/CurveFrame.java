package nephele.engine.xmlscene;

import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.model.CatmullRom;
import org.joml.Matrix4d;
import org.joml.Vector3d;

/** The frame of what goes around a closed curve; depends on nothing but the time. Allocates nothing after it is built. */
final class CurveFrame {
    /** A direction this close to upright has no upright of its own. */
    private static final double PARALLEL = 1e-9;

    private final CatmullRom curve;
    private final Vector3d ahead = new Vector3d();
    private final Vector3d side = new Vector3d();
    private final Vector3d upright = new Vector3d();

    CurveFrame(List<Vec3> through) {
        curve = CatmullRom.uniformLoop(through);
    }

    /** Multiplies a frame by one whose origin is on the curve and whose axes stay. */
    void carry(double round, Matrix4d frame) {
        curve.position(round, ahead);
        frame.translate(ahead);
    }

    /**
     * As {@link #carry}, with x along the curve, z = x × (0, 1, 0) and y = z × x. Where the curve is upright, z is
     * (0, 0, 1); where it stands still, x is the way it sets out, and a curve of one point turns nothing.
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
        // Across an upright that is not quite one, the side is not quite across.
        ahead.cross(upright, side);
        axes.set(
                ahead.x, ahead.y, ahead.z, 0, upright.x, upright.y, upright.z, 0, side.x, side.y, side.z, 0, 0, 0, 0,
                1);
        frame.mul(axes);
    }
}
