package nephele.engine.cloud.cells;

import java.util.Arrays;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.BoxTest;
import nephele.engine.math.bvh.SpatialIndex;

/**
 * Passes the boxes that another box meets on an endless way in one direction.
 *
 * @param from where it begins; sides may be infinite
 */
record BoxesAhead(Aabb from, Vec3 direction) implements BoxTest {
    /** Returns the items of an index whose boxes are met, in ascending order. */
    static int[] of(SpatialIndex index, Aabb from, Vec3 direction) {
        int[] found = new int[index.size()];
        int[] count = new int[1];
        index.query(new BoxesAhead(from, direction), item -> found[count[0]++] = item);
        int[] met = Arrays.copyOf(found, count[0]);
        Arrays.sort(met);
        return met;
    }

    @Override
    public boolean passes(double[] bounds, int at) {
        double enter = 0;
        double leave = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            double min = bounds[at + axis] - most(axis);
            double max = bounds[at + 3 + axis] - least(axis);
            double along = axis == 0 ? direction.x() : axis == 1 ? direction.y() : direction.z();
            if (along == 0) {
                if (min > 0 || max < 0) {
                    return false;
                }
            } else {
                enter = Math.max(enter, (along > 0 ? min : max) / along);
                leave = Math.min(leave, (along > 0 ? max : min) / along);
            }
        }
        return enter <= leave;
    }

    private double least(int axis) {
        return axis == 0 ? from.minX() : axis == 1 ? from.minY() : from.minZ();
    }

    private double most(int axis) {
        return axis == 0 ? from.maxX() : axis == 1 ? from.maxY() : from.maxZ();
    }
}
