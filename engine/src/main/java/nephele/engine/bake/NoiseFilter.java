package nephele.engine.bake;

import nephele.engine.scene.light.bake.LightMapChart;

/**
 * A filter of the noise of baked texels: each becomes a mean of its neighbours on the same chart, of which those count
 * that differ no more than the errors around explain (after Buades, Coll and Morel 2005, "A Non-Local Algorithm for Image
 * Denoising", with the measured errors in place of one parameter). Edges of light that are clearer than the noise stay,
 * and nothing passes from one chart to another.
 */
final class NoiseFilter {
    private static final int RADIUS = 3;

    /** The difference of two texels at which the weight is 1 / e, in standard errors of the difference. */
    private static final double SIGMAS = 1.5;

    private final Receivers receivers;
    private final int stride;
    private final float[] before;
    private final float[] errors;

    /**
     * Makes a filter.
     *
     * @param stride values of a receiver, those of a layer after those of another
     * @param values of all receivers; stay as they are
     * @param errors standard errors of the luminance of each receiver, negative for those that are not free
     */
    NoiseFilter(Receivers receivers, int stride, float[] values, float[] errors) {
        this.receivers = receivers;
        this.stride = stride;
        before = values;
        this.errors = errors;
    }

    /** Returns the values, filtered at texels. */
    float[] filtered() {
        float[] after = before.clone();
        for (int chart = 0; chart < receivers.layout().charts().size(); chart++) {
            LightMapChart of = receivers.layout().charts().get(chart);
            for (int row = 0; row < of.rows(); row++) {
                for (int column = 0; column < of.columns(); column++) {
                    filter(of, receivers.firstOfChart(chart), column, row, after);
                }
            }
        }
        return after;
    }

    private void filter(LightMapChart chart, int first, int column, int row, float[] after) {
        int at = first + row * chart.columns() + column;
        if (errors[at] <= 0) {
            return;
        }
        double[] sums = new double[stride];
        double weights = 0;
        double here = luminance(at);
        // A single error is known no better than to a quarter.
        double noise = 2 * SIGMAS * SIGMAS * variance(chart, first, column, row);
        for (int y = Math.max(0, row - RADIUS); y <= Math.min(row + RADIUS, chart.rows() - 1); y++) {
            for (int x = Math.max(0, column - RADIUS); x <= Math.min(column + RADIUS, chart.columns() - 1); x++) {
                int other = first + y * chart.columns() + x;
                if (errors[other] >= 0) {
                    double difference = luminance(other) - here;
                    double weight = StrictMath.exp(-difference * difference / noise);
                    weights += weight;
                    for (int i = 0; i < stride; i++) {
                        sums[i] += weight * before[stride * other + i];
                    }
                }
            }
        }
        for (int i = 0; i < stride; i++) {
            after[stride * at + i] = (float) (sums[i] / weights);
        }
    }

    /** Returns the mean variance of the texels around one. */
    private double variance(LightMapChart chart, int first, int column, int row) {
        double sum = 0;
        int count = 0;
        for (int y = Math.max(0, row - RADIUS); y <= Math.min(row + RADIUS, chart.rows() - 1); y++) {
            for (int x = Math.max(0, column - RADIUS); x <= Math.min(column + RADIUS, chart.columns() - 1); x++) {
                double error = errors[first + y * chart.columns() + x];
                sum += error >= 0 ? error * error : 0;
                count += error >= 0 ? 1 : 0;
            }
        }
        return sum / count;
    }

    private double luminance(int receiver) {
        double sum = 0;
        for (int i = stride * receiver; i < stride * (receiver + 1); i += Gathered.VALUES) {
            sum += Gathered.luminance(before[i], before[i + 1], before[i + 2]);
        }
        return sum;
    }
}
