package nephele.engine.collision.rigid;

import java.util.Arrays;
import nephele.engine.collision.Collider;
import nephele.engine.collision.HullDistance;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Separation;
import org.joml.Vector3dc;

/**
 * How far a fast body gets before it is a little way into another one that moves too: conservative advancement along
 * their relative way, both turned as at the start of the tick. Reused.
 */
final class FastPairs {
    private static final double TOUCH_METRES = 1e-8;
    private static final int MOST_STEPS = 32;

    private final Poses poses;
    private final NarrowPhase narrow;
    private final Separation separation = new Separation();
    private final HullDistance distance = new HullDistance();
    private final double[] axes = new double[9];
    /** Displacement of every body in this tick, as far as nothing stops it. */
    private double[] ways = new double[0];

    private double metres;
    private double approach;

    FastPairs(Poses poses, NarrowPhase narrow) {
        this.poses = poses;
        this.narrow = narrow;
    }

    void clear(int bodies) {
        if (ways.length < 3 * bodies) {
            ways = new double[3 * bodies];
        }
        Arrays.fill(ways, 0, 3 * bodies, 0);
    }

    void way(int body, double x, double y, double z) {
        ways[3 * body] = x;
        ways[3 * body + 1] = y;
        ways[3 * body + 2] = z;
    }

    /** The free share of a body's way from where it was at the start of the tick. */
    double free(int body, int bodies, Vector3dc way, double depth) {
        double free = 1;
        for (int other = 0; other < bodies; other++) {
            if (other != body && poses.overlap(body, other)) {
                free = Math.min(free, against(body, other, way, depth));
            }
        }
        return free;
    }

    private double against(int body, int other, Vector3dc way, double depth) {
        double x = way.x() - ways[3 * other];
        double y = way.y() - ways[3 * other + 1];
        double z = way.z() - ways[3 * other + 2];
        boolean box = poses.kind[other] == BodyTable.BOX;
        RoundedHull shape = box ? turnedInto(body, other) : narrow.turnedHull(body);
        double t = 0;
        for (int i = 0; i < MOST_STEPS; i++) {
            double dX = poses.centre[3 * body] - poses.centre[3 * other] + t * x;
            double dY = poses.centre[3 * body + 1] - poses.centre[3 * other + 1] + t * y;
            double dZ = poses.centre[3 * body + 2] - poses.centre[3 * other + 2] + t * z;
            if (box) {
                measureInBox(shape, other, dX, dY, dZ, x, y, z);
            } else {
                distance.measure(shape, dX, dY, dZ, narrow.turnedHull(other));
                metres = distance.metres();
                approach = -(distance.normalX() * x + distance.normalY() * y + distance.normalZ() * z);
            }
            double gap = metres + depth;
            if (gap <= TOUCH_METRES) {
                return i == 0 ? 1 : t;
            }
            if (approach <= 0) {
                return 1;
            }
            t += gap / approach;
            if (t >= 1) {
                return 1;
            }
        }
        return t;
    }

    private RoundedHull turnedInto(int body, int box) {
        for (int i = 0; i < 9; i++) {
            axes[i] = along(9 * body + 3 * (i / 3), 9 * box + 3 * (i % 3));
        }
        return narrow.turnedBy(body, axes);
    }

    private double along(int p, int q) {
        double[] x = poses.axes;
        return x[p] * x[q] + x[p + 1] * x[q + 1] + x[p + 2] * x[q + 2];
    }

    private void measureInBox(
            RoundedHull shape, int box, double dX, double dY, double dZ, double x, double y, double z) {
        Collider solid = narrow.boxSolid(box);
        separation.measure(
                shape, local(box, 0, dX, dY, dZ), local(box, 1, dX, dY, dZ), local(box, 2, dX, dY, dZ), solid);
        metres = separation.metres();
        approach = -(separation.normalX() * local(box, 0, x, y, z)
                + separation.normalY() * local(box, 1, x, y, z)
                + separation.normalZ() * local(box, 2, x, y, z));
    }

    private double local(int box, int axis, double x, double y, double z) {
        int at = 9 * box + 3 * axis;
        return poses.axes[at] * x + poses.axes[at + 1] * y + poses.axes[at + 2] * z;
    }
}
