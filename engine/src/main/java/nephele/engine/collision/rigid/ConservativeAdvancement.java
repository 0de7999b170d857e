package nephele.engine.collision.rigid;

import java.util.function.IntPredicate;
import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Separation;
import nephele.engine.math.bvh.ItemList;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Continuous collision detection of a fast body with solids: conservative advancement (Mirtich 1996) until it is
 * slightly inside, not in front: a surface that it slides along does not stop it, and the next tick's solver finds the
 * contact. A body already that deep in a solid may leave it and slide along it, but not go deeper. Reused.
 */
final class ConservativeAdvancement {
    /**
     * Inward motion per metre of displacement below which the body is sliding: the rounding error of a tangent
     * direction.
     */
    static final double SLIDING_METRES_PER_METRE = 1e-9;

    private static final double TOUCH_METRES = 1e-8;
    private static final int MOST_STEPS = 64;

    private final Separation separation = new Separation();
    private final ItemList near = new ItemList();
    private final double[] box = new double[6];
    private final Vector3d normal = new Vector3d();

    /**
     * Returns the free share of a displacement, 0 to 1.
     *
     * @param depth greatest depth that the body may reach, in metres
     * @param isLeftOut the solids, by index, to skip
     */
    double free(
            CollisionWorld world,
            RoundedHull shape,
            Vector3dc from,
            Vector3dc way,
            double depth,
            IntPredicate isLeftOut) {
        find(world, shape, from, way);
        double free = 1;
        for (int i = 0; i < near.size() && free > 0; i++) {
            free = isLeftOut.test(near.get(i))
                    ? free
                    : Math.min(free, against(world.collider(near.get(i)), shape, from, way, depth));
        }
        return free;
    }

    /** Returns the outward unit normal of the solid that left no free share. */
    Vector3dc normal() {
        return normal;
    }

    /**
     * Returns the distance in metres from a shape to the nearest solid that its bounds touch; negative inside, infinite
     * for none.
     */
    double gap(CollisionWorld world, RoundedHull shape, Vector3dc at) {
        find(world, shape, at, normal.zero());
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < near.size(); i++) {
            separation.measure(shape, at.x(), at.y(), at.z(), world.collider(near.get(i)));
            least = Math.min(least, separation.metres());
        }
        return least;
    }

    private void find(CollisionWorld world, RoundedHull shape, Vector3dc from, Vector3dc way) {
        for (int axis = 0; axis < 3; axis++) {
            double start = from.get(axis);
            double move = way.get(axis);
            box[axis] = start + shape.least(axis) + Math.min(0, move);
            box[3 + axis] = start + shape.greatest(axis) + Math.max(0, move);
        }
        world.overlapping(box, 0, near);
    }

    private double against(Collider solid, RoundedHull shape, Vector3dc from, Vector3dc way, double depth) {
        double t = 0;
        for (int i = 0; i < MOST_STEPS; i++) {
            separation.measure(shape, from.x() + t * way.x(), from.y() + t * way.y(), from.z() + t * way.z(), solid);
            double gap = separation.metres() + depth;
            double approach = separation.approach(way);
            if (gap <= TOUCH_METRES && i > 0) {
                return t;
            }
            if (approach <= (gap <= TOUCH_METRES ? SLIDING_METRES_PER_METRE * way.length() : 0)) {
                return 1;
            }
            if (gap <= TOUCH_METRES) {
                normal.set(separation.normal());
                return 0;
            }
            t += gap / approach;
            if (t >= 1) {
                return 1;
            }
        }
        return t;
    }
}
