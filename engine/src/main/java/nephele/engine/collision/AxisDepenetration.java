package nephele.engine.collision;

import java.util.Arrays;
import nephele.engine.math.Aabb;
import nephele.engine.math.bvh.ItemList;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The shortest displacement along one of the six axis directions that frees a shape from all solids. It replaces the
 * solids by their bounding boxes, so the displacement may be longer than necessary but never too short; it always
 * terminates, in the time of a sort. Reused for every query.
 */
final class AxisDepenetration {
    /** Overlap to the sides that counts as touching only. */
    private static final double TOUCH_METRES = 1e-6;

    private final ItemList near = new ItemList();
    private final Vector3d displacement = new Vector3d();
    private final Vector3d sweep = new Vector3d();
    private double[][] spans = new double[0][];
    private double metres;

    /** Returns the displacement found; it ends {@link Sweep#SKIN_METRES} from the last solid. */
    Vector3dc displacement() {
        return displacement;
    }

    double metres() {
        return metres;
    }

    /** Finds the shortest displacement and returns its length, {@link #metres}. */
    double find(CollisionWorld world, RoundedHull shape, Vector3dc at) {
        metres = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            for (int sign = -1; sign <= 1; sign += 2) {
                double gap = firstGap(world, shape, at, axis, sign);
                if (gap < metres) {
                    metres = gap;
                    displacement.zero().setComponent(axis, sign * gap);
                }
            }
        }
        return metres;
    }

    /** Returns the distance along the direction at which the shape's box is first clear of all other boxes. */
    private double firstGap(CollisionWorld world, RoundedHull shape, Vector3dc at, int axis, int sign) {
        Aabb all = world.extent();
        double end = sign > 0
                ? greatest(all, axis) - at.get(axis) - shape.least(axis)
                : at.get(axis) + shape.greatest(axis) - least(all, axis);
        sweep.zero().setComponent(axis, sign * Math.max(0, end));
        world.near(shape, at, sweep, -TOUCH_METRES, near);
        if (spans.length < near.size()) {
            spans = new double[2 * near.size()][2];
        }
        for (int i = 0; i < near.size(); i++) {
            span(world.collider(near.get(i)).bounds(), shape, at.get(axis), axis, sign, spans[i]);
        }
        Arrays.sort(spans, 0, near.size(), (a, b) -> Double.compare(a[0], b[0]));
        double gap = 0;
        for (int i = 0; i < near.size() && spans[i][0] <= gap; i++) {
            gap = Math.max(gap, spans[i][1]);
        }
        return gap;
    }

    /** Writes the interval of distances along the direction in which the shape overlaps a box or its skin. */
    private static void span(Aabb box, RoundedHull shape, double at, int axis, int sign, double[] span) {
        double begin =
                sign > 0 ? least(box, axis) - at - shape.greatest(axis) : at + shape.least(axis) - greatest(box, axis);
        double end =
                sign > 0 ? greatest(box, axis) - at - shape.least(axis) : at + shape.greatest(axis) - least(box, axis);
        span[0] = begin - Sweep.SKIN_METRES;
        span[1] = end + Sweep.SKIN_METRES;
    }

    /** Returns the least distance along an axis that clears the shape's box of another box; 0 when it is clear. */
    static double depth(RoundedHull shape, Vector3dc at, Aabb box) {
        double least = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            least = Math.min(least, greatest(box, axis) - at.get(axis) - shape.least(axis));
            least = Math.min(least, at.get(axis) + shape.greatest(axis) - least(box, axis));
        }
        return Math.max(0, least);
    }

    private static double least(Aabb box, int axis) {
        return axis == 0 ? box.minX() : axis == 1 ? box.minY() : box.minZ();
    }

    private static double greatest(Aabb box, int axis) {
        return axis == 0 ? box.maxX() : axis == 1 ? box.maxY() : box.maxZ();
    }
}
