package nephele.engine.collision.rigid;

import java.util.Arrays;
import nephele.engine.collision.rigid.body.Poses;
import nephele.engine.math.bvh.ItemList;

/**
 * Pairs of shapes with overlapping bounds (Baraff 1992; Cohen et al. 1995): sorted along the axis on which the centres
 * have the greatest variance, by least bound and then by index, so that the order depends only on the bounds. Sorting
 * starts from the last order.
 */
final class SweepAndPrune {
    private int[] order = new int[0];
    private double[] from = new double[0];

    /** Lists every pair: two numbers each, the lower index first. */
    void find(Poses poses, ItemList pairs) {
        pairs.clear();
        int axis = widestAxis(poses);
        sort(poses, axis);
        double[] bounds = poses.bounds;
        for (int i = 0; i < poses.count; i++) {
            int a = order[i];
            double until = bounds[Poses.BOUNDS * a + 3 + axis];
            for (int j = i + 1; j < poses.count && from[j] <= until; j++) {
                int b = order[j];
                if (poses.overlap(a, b)) {
                    pairs.accept(Math.min(a, b));
                    pairs.accept(Math.max(a, b));
                }
            }
        }
    }

    private static int widestAxis(Poses poses) {
        int widest = 0;
        double most = -1;
        for (int axis = 0; axis < 3; axis++) {
            double sum = 0;
            double squares = 0;
            double origin = poses.count == 0 ? 0 : poses.centre[axis];
            for (int i = 0; i < poses.count; i++) {
                double c = poses.centre[3 * i + axis] - origin;
                sum += c;
                squares += c * c;
            }
            double variance = squares - sum * sum / Math.max(1, poses.count);
            if (variance > most) {
                most = variance;
                widest = axis;
            }
        }
        return widest;
    }

    private void sort(Poses poses, int axis) {
        if (order.length != poses.count) {
            order = new int[poses.count];
            from = new double[poses.count];
            Arrays.setAll(order, i -> i);
        }
        for (int i = 0; i < order.length; i++) {
            int shape = order[i];
            double least = poses.bounds[Poses.BOUNDS * shape + axis];
            int at = i;
            while (at > 0 && (from[at - 1] > least || (from[at - 1] == least && order[at - 1] > shape))) {
                from[at] = from[at - 1];
                order[at] = order[at - 1];
                at--;
            }
            from[at] = least;
            order[at] = shape;
        }
    }
}
