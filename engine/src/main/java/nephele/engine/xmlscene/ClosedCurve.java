package nephele.engine.xmlscene;

import java.util.List;
import nephele.engine.math.Vec3;
import org.joml.Matrix4d;
import org.joml.Vector3d;

/**
 * A loop through points, as long in time between any two of them: uniform Catmull-Rom (Catmull and Rom 1974, tension ½).
 * Where it is depends on nothing but the time. Allocates nothing after it is built.
 */
final class ClosedCurve {
    /** A direction this close to upright has no upright of its own. */
    private static final double PARALLEL = 1e-9;

    private final double[] points;
    private final int count;
    private final Vector3d ahead = new Vector3d();
    private final Vector3d side = new Vector3d();
    private final Vector3d upright = new Vector3d();

    ClosedCurve(List<Vec3> through) {
        count = through.size();
        points = new double[3 * count];
        for (int i = 0; i < count; i++) {
            points[3 * i] = through.get(i).x();
            points[3 * i + 1] = through.get(i).y();
            points[3 * i + 2] = through.get(i).z();
        }
    }

    /** @param round any number; whole ones are at the first point */
    void position(double round, Vector3d position) {
        double at = along(round);
        int segment = Math.min((int) at, count - 1);
        double s = at - segment;
        sum(
                segment,
                ((2 - s) * s - 1) * s / 2,
                ((3 * s - 5) * s * s + 2) / 2,
                ((4 - 3 * s) * s + 1) * s / 2,
                (s - 1) * s * s / 2,
                position);
    }

    /** Change of position for a whole round. */
    void derivative(double round, Vector3d derivative) {
        double at = along(round);
        int segment = Math.min((int) at, count - 1);
        double s = at - segment;
        sum(
                segment,
                ((4 - 3 * s) * s - 1) / 2,
                (9 * s - 10) * s / 2,
                ((8 - 9 * s) * s + 1) / 2,
                (3 * s - 2) * s / 2,
                derivative);
        derivative.mul(count);
    }

    private void secondDerivative(double round, Vector3d derivative) {
        double at = along(round);
        int segment = Math.min((int) at, count - 1);
        double s = at - segment;
        sum(segment, 2 - 3 * s, 9 * s - 5, 4 - 9 * s, 3 * s - 1, derivative);
        derivative.mul((double) count * count);
    }

    /** In points; at most {@code count}, which rounding makes of the last instant. */
    private double along(double round) {
        return (round - Math.floor(round)) * count;
    }

    private void sum(int segment, double before, double from, double to, double after, Vector3d result) {
        int a = 3 * ((segment + count - 1) % count);
        int b = 3 * segment;
        int c = 3 * ((segment + 1) % count);
        int d = 3 * ((segment + 2) % count);
        result.set(
                before * points[a] + from * points[b] + to * points[c] + after * points[d],
                before * points[a + 1] + from * points[b + 1] + to * points[c + 1] + after * points[d + 1],
                before * points[a + 2] + from * points[b + 2] + to * points[c + 2] + after * points[d + 2]);
    }

    /** Multiplies a frame by one whose origin is on the curve and whose axes stay. */
    void carry(double round, Matrix4d frame) {
        position(round, ahead);
        frame.translate(ahead);
    }

    /**
     * As {@link #carry}, with x along the curve, z = x × (0, 1, 0) and y = z × x. Where the curve is upright, z is
     * (0, 0, 1); where it stands still, x is the way it sets out, and a curve of one point turns nothing.
     */
    void carryAligned(double round, Matrix4d frame, Matrix4d axes) {
        carry(round, frame);
        derivative(round, ahead);
        if (ahead.lengthSquared() == 0) {
            secondDerivative(round, ahead);
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
