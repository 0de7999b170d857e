package nephele.engine.collision.rigid;

import java.util.Arrays;
import java.util.function.IntPredicate;
import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Separation;
import nephele.engine.collision.Sweep;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.collision.rigid.body.Poses;
import nephele.engine.collision.rigid.contact.NarrowPhase;
import nephele.engine.math.bvh.ItemList;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Continuous collision detection of a fast body: conservative advancement (Mirtich 1996) along its displacement until it
 * is slightly inside an obstacle, not in front: a surface that it slides along does not stop it, and the next tick's
 * solver finds the contact. A body already that deep in an obstacle may leave it and slide along it, but not go deeper.
 *
 * <p>Obstacles are solids, and other moving bodies and characters, along the displacement relative to them, both with
 * their orientation at the start of the tick. Reused.
 */
final class ContinuousCollision {
    private static final int MOST_STEPS_TO_SOLID = 64;
    private static final int MOST_STEPS_TO_BODY = 32;

    private final Poses poses;
    private final NarrowPhase narrow;
    private final Separation separation = new Separation();
    private final ItemList near = new ItemList();
    private final double[] box = new double[6];
    private final double[] axes = new double[9];
    /** Unobstructed displacement of every body and character in this tick, three numbers each. */
    private double[] displacements = new double[0];

    private BodyInfluences influences;
    private int bodies;
    /** The advancing shape, its place, its displacement, and the displacement relative to the obstacle. */
    private RoundedHull shape;

    private Vector3dc from;
    private Vector3dc displacement;
    private final Vector3d relative = new Vector3d();
    /** The obstacle: a solid, or the owner of a moving shape if that is {@code null}. */
    private Collider solid;

    private int other;
    /** The last measured distance, the unit vector out of the obstacle there, and the motion against it. */
    private double metres;

    private final Vector3d away = new Vector3d();
    private double approach;
    private final Vector3d normal = new Vector3d();

    ContinuousCollision(Poses poses, NarrowPhase narrow) {
        this.poses = poses;
        this.narrow = narrow;
    }

    /** Begins a tick, in which characters move with their velocities and bodies not at all, unless {@link #expect} says so. */
    void begin(int bodiesOfTick, BodyInfluences from, double seconds) {
        bodies = bodiesOfTick;
        influences = from;
        int count = bodies + influences.characters();
        if (displacements.length < 3 * count) {
            displacements = new double[3 * count];
        }
        Arrays.fill(displacements, 0, 3 * count, 0);
        for (int i = bodies; i < count; i++) {
            Vector3dc v = influences.characterList().get(i - bodies).velocity;
            expect(i, v.x() * seconds, v.y() * seconds, v.z() * seconds);
        }
    }

    /** Sets the displacement in this tick of a body or character without obstacles. */
    void expect(int owner, double x, double y, double z) {
        displacements[3 * owner] = x;
        displacements[3 * owner + 1] = y;
        displacements[3 * owner + 2] = z;
    }

    /** Returns the outward unit normal of the obstacle that left no free fraction. */
    Vector3dc normal() {
        return normal;
    }

    /**
     * Returns the fraction of a body's displacement that is free of other bodies and characters, 0 to 1.
     *
     * @param depth greatest depth that the body may reach, in metres
     * @param hasCrossed true if the body went through a portal in this tick: the others then count as at the tick's
     *     start
     * @param isLeftOut the others, by owner, to skip
     */
    double freeOfBodies(
            int body, Vector3dc start, Vector3dc path, double depth, boolean hasCrossed, IntPredicate isLeftOut) {
        int count = bodies + (influences.meetsCharacters(body) ? influences.characters() : 0);
        from = start;
        displacement = path;
        solid = null;
        double free = 1;
        for (other = 0; other < count && free > 0; other++) {
            if (other != body && isNear(body) && !isLeftOut.test(other)) {
                relative.set(path);
                if (!hasCrossed) {
                    int d = 3 * other;
                    relative.sub(displacements[d], displacements[d + 1], displacements[d + 2]);
                }
                shape = poses.kind[other] == BodyTable.BOX ? turnedInto(body, other) : narrow.turnedHull(body);
                free = Math.min(free, advance(MOST_STEPS_TO_BODY, depth));
            }
        }
        return free;
    }

    private boolean isNear(int body) {
        for (int axis = 0; axis < 3; axis++) {
            double gap = from.get(axis) - poses.centre[3 * other + axis];
            double own = displacement.get(axis);
            double its = displacements[3 * other + axis];
            double reach = poses.extent(body, axis) + poses.extent(other, axis);
            if (gap + Math.min(0, own) - Math.max(0, its) > reach
                    || gap + Math.max(0, own) - Math.min(0, its) < -reach) {
                return false;
            }
        }
        return true;
    }

    private RoundedHull turnedInto(int body, int boxBody) {
        for (int i = 0; i < 9; i++) {
            axes[i] = dot(Poses.AXES * body + 3 * (i / 3), Poses.AXES * boxBody + 3 * (i % 3));
        }
        return narrow.turnedBy(body, axes);
    }

    private double dot(int p, int q) {
        double[] x = poses.axes;
        return x[p] * x[q] + x[p + 1] * x[q + 1] + x[p + 2] * x[q + 2];
    }

    /**
     * Returns the fraction of a displacement that is free of solids, 0 to 1.
     *
     * @param depth greatest depth that the body may reach, in metres
     * @param isLeftOut the solids, by index, to skip
     */
    double freeOfSolids(
            CollisionWorld world,
            RoundedHull hull,
            Vector3dc start,
            Vector3dc path,
            double depth,
            IntPredicate isLeftOut) {
        find(world, hull, start, path);
        shape = hull;
        from = start;
        displacement = path;
        relative.set(path);
        double free = 1;
        for (int i = 0; i < near.size() && free > 0; i++) {
            if (!isLeftOut.test(near.get(i))) {
                solid = world.collider(near.get(i));
                free = Math.min(free, advance(MOST_STEPS_TO_SOLID, depth));
            }
        }
        return free;
    }

    /**
     * Returns the distance in metres from a shape to the nearest solid that its bounds touch; negative inside, infinite
     * for none.
     */
    double gap(CollisionWorld world, RoundedHull hull, Vector3dc at) {
        find(world, hull, at, relative.zero());
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < near.size(); i++) {
            separation.measure(hull, at.x(), at.y(), at.z(), world.collider(near.get(i)));
            least = Math.min(least, separation.metres());
        }
        return least;
    }

    private void find(CollisionWorld world, RoundedHull hull, Vector3dc start, Vector3dc path) {
        for (int axis = 0; axis < 3; axis++) {
            double at = start.get(axis);
            double move = path.get(axis);
            box[axis] = at + hull.least(axis) + Math.min(0, move);
            box[3 + axis] = at + hull.greatest(axis) + Math.max(0, move);
        }
        world.overlapping(box, 0, near);
    }

    /** Returns the fraction of the displacement before the obstacle, 1 if it does not stop the shape. */
    private double advance(int mostSteps, double depth) {
        double t = 0;
        for (int i = 0; i < mostSteps; i++) {
            measure(t);
            double gap = metres + depth;
            boolean touches = gap <= Sweep.TOUCH_METRES;
            if (touches && i > 0) {
                return t;
            }
            // A body deep inside at the start is not stopped by another that follows it: the other one is.
            double inward = touches && solid == null ? Math.min(approach, -away.dot(displacement)) : approach;
            if (inward <= (touches ? Sweep.SLIDING_METRES_PER_METRE * relative.length() : 0)) {
                return 1;
            }
            if (touches) {
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

    /** Sets {@link #metres}, {@link #away} in world axes and {@link #approach} at a fraction of the displacement. */
    private void measure(double t) {
        if (solid != null) {
            separation.measure(
                    shape, from.x() + t * relative.x, from.y() + t * relative.y, from.z() + t * relative.z, solid);
            metres = separation.metres();
            away.set(separation.normal());
            approach = separation.approach(relative);
            return;
        }
        double dX = from.x() - poses.centre[3 * other] + t * relative.x;
        double dY = from.y() - poses.centre[3 * other + 1] + t * relative.y;
        double dZ = from.z() - poses.centre[3 * other + 2] + t * relative.z;
        if (poses.kind[other] == BodyTable.BOX) {
            measureInBox(dX, dY, dZ);
        } else {
            RoundedHull its = other < bodies
                    ? narrow.turnedHull(other)
                    : influences.characterList().get(other - bodies).upright;
            separation.measure(shape, dX, dY, dZ, its);
            away.set(separation.normal());
        }
        metres = separation.metres();
        approach = -away.dot(relative);
    }

    private void measureInBox(double dX, double dY, double dZ) {
        separation.measure(
                shape, local(0, dX, dY, dZ), local(1, dX, dY, dZ), local(2, dX, dY, dZ), narrow.boxSolid(other));
        away.zero();
        for (int axis = 0; axis < 3; axis++) {
            double part = separation.normal().get(axis);
            int at = Poses.AXES * other + 3 * axis;
            away.add(part * poses.axes[at], part * poses.axes[at + 1], part * poses.axes[at + 2]);
        }
    }

    private double local(int axis, double x, double y, double z) {
        int at = Poses.AXES * other + 3 * axis;
        return poses.axes[at] * x + poses.axes[at + 1] * y + poses.axes[at + 2] * z;
    }
}
