package nephele.engine.math;

import java.util.Arrays;

/** Item counts and bounds along one axis, from which the cheapest split by surface area is read. */
final class SplitBins {
    private final int bins;
    private final int[] count;
    private final double[] bounds;
    private final double[] costAfter;
    private final double[] sweep = new double[6];
    private double low;
    private double scale;

    SplitBins(int bins) {
        this.bins = bins;
        count = new int[bins];
        bounds = new double[6 * bins];
        costAfter = new double[bins];
    }

    /** Begins anew over centres in [low, high]; false when they are too close together to be told apart. */
    boolean start(double lowest, double highest) {
        low = lowest;
        scale = bins / (highest - lowest);
        Arrays.fill(count, 0);
        for (int bin = 0; bin < bins; bin++) {
            clear(bounds, 6 * bin);
        }
        return scale > 0 && scale <= Double.MAX_VALUE;
    }

    int binOf(double centre) {
        return Math.min(bins - 1, (int) ((centre - low) * scale));
    }

    void add(double centre, double[] boxes, int at) {
        int bin = binOf(centre);
        count[bin]++;
        union(bounds, 6 * bin, boxes, at);
    }

    /** The last bin of the left side. Both sides hold items: the lowest centre is in the first bin, the highest last. */
    int cheapest() {
        sweepFromRight();
        clear(sweep, 0);
        int left = 0;
        int best = 0;
        for (int bin = 0; bin < bins - 1; bin++) {
            left += count[bin];
            union(sweep, 0, bounds, 6 * bin);
            costAfter[bin] += left * halfArea(sweep);
            if (costAfter[bin] < costAfter[best]) {
                best = bin;
            }
        }
        return best;
    }

    double cost(int bin) {
        return costAfter[bin];
    }

    private void sweepFromRight() {
        clear(sweep, 0);
        int rightCount = 0;
        for (int bin = bins - 1; bin > 0; bin--) {
            rightCount += count[bin];
            union(sweep, 0, bounds, 6 * bin);
            costAfter[bin - 1] = rightCount * halfArea(sweep);
        }
    }

    private static void clear(double[] bounds, int at) {
        Arrays.fill(bounds, at, at + 3, Double.POSITIVE_INFINITY);
        Arrays.fill(bounds, at + 3, at + 6, Double.NEGATIVE_INFINITY);
    }

    private static void union(double[] bounds, int at, double[] box, int boxAt) {
        for (int axis = 0; axis < 3; axis++) {
            bounds[at + axis] = Math.min(bounds[at + axis], box[boxAt + axis]);
            bounds[at + 3 + axis] = Math.max(bounds[at + 3 + axis], box[boxAt + 3 + axis]);
        }
    }

    private static double halfArea(double[] box) {
        double x = box[3] - box[0];
        double y = box[4] - box[1];
        double z = box[5] - box[2];
        return x < 0 ? 0 : x * y + y * z + z * x;
    }
}
