package nephele.engine.collision.rigid;

import java.util.Arrays;
import java.util.function.IntPredicate;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Separation;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.collision.rigid.body.Poses;
import nephele.engine.collision.rigid.contact.NarrowPhase;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Continuous collision detection of a fast body with other moving bodies and characters: conservative advancement along
 * the relative displacement until it is slightly inside, both with their orientation at the start of the tick. Reused.
 */
final class ContinuousPairs {
    private static final double TOUCH_METRES = 1e-8;
    private static final int MOST_STEPS = 32;

    private final Poses poses;
    private final NarrowPhase narrow;
    private final Separation separation = new Separation();
    private final double[] axes = new double[9];
    /** Unobstructed displacement of every body and character in this tick. */
    private double[] ways = new double[0];

    private final Vector3d relative = new Vector3d();
    private final Vector3d away = new Vector3d();
    private final Vector3d normal = new Vector3d();
    private BodyInfluences influences;
    private int bodies;
    private double metres;

    ContinuousPairs(Poses poses, NarrowPhase narrow) {
        this.poses = poses;
        this.narrow = narrow;
    }

    void begin(int bodiesOfTick, BodyInfluences from, double seconds) {
        bodies = bodiesOfTick;
        influences = from;
        int count = bodies + influences.characters();
        if (ways.length < 3 * count) {
            ways = new double[3 * count];
        }
        Arrays.fill(ways, 0, 3 * count, 0);
        for (int i = bodies; i < count; i++) {
            Vector3dc v = influences.characterList().get(i - bodies).velocity;
            way(i, v.x() * seconds, v.y() * seconds, v.z() * seconds);
        }
    }

    void way(int body, double x, double y, double z) {
        ways[3 * body] = x;
        ways[3 * body + 1] = y;
        ways[3 * body + 2] = z;
    }

    /**
     * Returns the free share of a body's displacement, 0 to 1.
     *
     * @param isLeftOut the others, by owner, to skip
     * @param hasCrossed true if the body went through a portal in this tick: the others then count as at the tick's
     * start
     */
    double free(int body, Vector3dc from, Vector3dc way, double depth, boolean hasCrossed, IntPredicate isLeftOut) {
        int count = bodies + (influences.meetsCharacters(body) ? influences.characters() : 0);
        double free = 1;
        for (int other = 0; other < count && free > 0; other++) {
            if (other != body && isNear(body, from, way, other) && !isLeftOut.test(other)) {
                relative.set(way);
                if (!hasCrossed) {
                    relative.sub(ways[3 * other], ways[3 * other + 1], ways[3 * other + 2]);
                }
                free = Math.min(free, against(body, other, from, way, depth));
            }
        }
        return free;
    }

    /** Returns the outward unit normal of the obstacle that left no free share. */
    Vector3dc normal() {
        return normal;
    }

    private boolean isNear(int body, Vector3dc from, Vector3dc way, int other) {
        for (int axis = 0; axis < 3; axis++) {
            double gap = from.get(axis) - poses.centre[3 * other + axis];
            double own = way.get(axis);
            double its = ways[3 * other + axis];
            double reach = poses.extent(body, axis) + poses.extent(other, axis);
            if (gap + Math.min(0, own) - Math.max(0, its) > reach
                    || gap + Math.max(0, own) - Math.min(0, its) < -reach) {
                return false;
            }
        }
        return true;
    }

    private double against(int body, int other, Vector3dc from, Vector3dc way, double depth) {
        boolean box = poses.kind[other] == BodyTable.BOX;
        RoundedHull shape = box ? turnedInto(body, other) : narrow.turnedHull(body);
        double t = 0;
        for (int i = 0; i < MOST_STEPS; i++) {
            measure(shape, other, from, t);
            double gap = metres + depth;
            double approach = -away.dot(relative);
            if (gap <= TOUCH_METRES && i > 0) {
                return t;
            }
            // A body deep inside at the start is not stopped by another that follows it: the other one is.
            double inward = gap <= TOUCH_METRES ? Math.min(approach, -away.dot(way)) : approach;
            if (inward
                    <= (gap <= TOUCH_METRES
                            ? ConservativeAdvancement.SLIDING_METRES_PER_METRE * relative.length()
                            : 0)) {
                return 1;
            }
            if (gap <= TOUCH_METRES) {
                normal.set(away);
                return 0;
            }
            t += gap / approach;
            if (t >= 1) {
                return 1;
            }
        }
        return t;
    }

    /** Sets {@link #metres} and {@link #away}, the outward direction in world axes. */
    private void measure(RoundedHull shape, int other, Vector3dc from, double t) {
        double dX = from.x() - poses.centre[3 * other] + t * relative.x;
        double dY = from.y() - poses.centre[3 * other + 1] + t * relative.y;
        double dZ = from.z() - poses.centre[3 * other + 2] + t * relative.z;
        if (poses.kind[other] == BodyTable.BOX) {
            measureInBox(shape, other, dX, dY, dZ);
            return;
        }
        RoundedHull its = other < bodies
                ? narrow.turnedHull(other)
                : influences.characterList().get(other - bodies).upright;
        separation.measure(shape, dX, dY, dZ, its);
        metres = separation.metres();
        away.set(separation.normal());
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

    private void measureInBox(RoundedHull shape, int box, double dX, double dY, double dZ) {
        separation.measure(
                shape,
                local(box, 0, dX, dY, dZ),
                local(box, 1, dX, dY, dZ),
                local(box, 2, dX, dY, dZ),
                narrow.boxSolid(box));
        metres = separation.metres();
        away.zero();
        for (int axis = 0; axis < 3; axis++) {
            double part = separation.normal().get(axis);
            int at = 9 * box + 3 * axis;
            away.add(part * poses.axes[at], part * poses.axes[at + 1], part * poses.axes[at + 2]);
        }
    }

    private double local(int box, int axis, double x, double y, double z) {
        int at = 9 * box + 3 * axis;
        return poses.axes[at] * x + poses.axes[at + 1] * y + poses.axes[at + 2] * z;
    }
}
