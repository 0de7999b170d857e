package nephele.engine.math.bvh;

import java.util.Arrays;

/** Item counts and bounds along one axis, for the cheapest split by surface area. */
final class SahBins {
    private final int bins;
    private final int[] count;
    private final double[] bounds;
    private final double[] costAfter;
    private final double[] sweep = new double[6];
    private double low;
    private double scale;

    SahBins(int bins) {
        this.bins = bins;
        count = new int[bins];
        bounds = new double[6 * bins];
        costAfter = new double[bins];
    }

    /** Clears the bins for centres in [low, high]; returns false if the interval is too narrow to be divided. */
    boolean start(double lowest, double highest) {
        low = lowest;
        scale = bins / (highest - lowest);
        Arrays.fill(count, 0);
        return scale > 0 && scale <= Double.MAX_VALUE;
    }

    int binOf(double centre) {
        return Math.min(bins - 1, (int) ((centre - low) * scale));
    }

    void add(double centre, double[] boxes, int at) {
        int bin = binOf(centre);
        if (count[bin]++ == 0) {
            System.arraycopy(boxes, at, bounds, 6 * bin, 6);
        } else {
            SpatialTreeBuilder.grow(bounds, 6 * bin, boxes, at);
        }
    }

    /**
     * Returns the last bin of the left side of the cheapest split. Empty bins are skipped: a split after one costs the
     * same as the split before it. Both sides hold items, because the lowest centre is in the first bin and the highest
     * in the last.
     */
    int cheapest() {
        sweepFromRight();
        clearSweep();
        int left = 0;
        int best = 0;
        for (int bin = 0; bin < bins - 1; bin++) {
            if (count[bin] == 0) {
                continue;
            }
            left += count[bin];
            SpatialTreeBuilder.grow(sweep, 0, bounds, 6 * bin);
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
        clearSweep();
        int rightCount = 0;
        double cost = 0;
        for (int bin = bins - 1; bin > 0; bin--) {
            if (count[bin] > 0) {
                rightCount += count[bin];
                SpatialTreeBuilder.grow(sweep, 0, bounds, 6 * bin);
                cost = rightCount * halfArea(sweep);
            }
            costAfter[bin - 1] = cost;
        }
    }

    private void clearSweep() {
        Arrays.fill(sweep, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(sweep, 3, 6, Double.NEGATIVE_INFINITY);
    }

    private static double halfArea(double[] box) {
        double x = box[3] - box[0];
        double y = box[4] - box[1];
        double z = box[5] - box[2];
        return x < 0 ? 0 : x * y + y * z + z * x;
    }
}
