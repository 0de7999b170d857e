package nephele.engine.bake;

import java.util.stream.IntStream;
import nephele.engine.scene.light.bake.LightMapChart;

/**
 * A filter of the noise of baked texels: each becomes a mean of its neighbours on the same chart, of which those count
 * that differ no more than the errors around explain (after Buades, Coll and Morel 2005, "A Non-Local Algorithm for Image
 * Denoising", with the measured errors in place of one parameter). Edges of light that are clearer than the noise stay,
 * and nothing passes from one chart to another. Weights are balanced until each texel gives as much as it takes (Milanfar
 * 2013, "Symmetrizing Smoothing Filters"): else the rare bright values of noise, which differ most, would be lost.
 */
final class NoiseFilter {
    private static final int RADIUS = 3;
    private static final int SIDE = 2 * RADIUS + 1;
    private static final int AROUND = SIDE * SIDE;

    /** What is left of the difference between a texel's giving and taking halves in each. */
    private static final int BALANCING_STEPS = 10;

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
        IntStream.range(0, receivers.layout().charts().size()).parallel().forEach(chart -> new OfChart(chart)
                .filter(after));
        return after;
    }

    /** The texels of a chart, and the weights between each and those around it. */
    private final class OfChart {
        private final int columns;
        private final int rows;
        private final int first;
        private final float[] weights;
        private final double[] scales;

        OfChart(int index) {
            LightMapChart chart = receivers.layout().charts().get(index);
            columns = chart.columns();
            rows = chart.rows();
            first = receivers.firstOfChart(index);
            weights = new float[AROUND * columns * rows];
            scales = new double[columns * rows];
        }

        void filter(float[] after) {
            double[] variances = new double[scales.length];
            for (int at = 0; at < scales.length; at++) {
                scales[at] = errors[first + at] > 0 ? 1 : 0;
                variances[at] = variance(at);
            }
            for (int at = 0; at < scales.length; at++) {
                weigh(at, variances);
            }
            for (int step = 0; step < BALANCING_STEPS; step++) {
                balance();
            }
            for (int at = 0; at < scales.length; at++) {
                if (scales[at] > 0) {
                    mean(at, after);
                }
            }
        }

        private void weigh(int at, double[] variances) {
            forAround(at, (i, other) -> weights[AROUND * at + i] = weight(at, other, variances));
        }

        private float weight(int at, int other, double[] variances) {
            if (scales[at] == 0 || scales[other] == 0) {
                return 0;
            }
            double difference = luminance(first + other) - luminance(first + at);
            double noise = SIGMAS * SIGMAS * (variances[at] + variances[other]);
            return (float) StrictMath.exp(-difference * difference / noise);
        }

        /** Brings the sum of each texel's scaled weights nearer to 1. */
        private void balance() {
            double[] next = new double[scales.length];
            for (int at = 0; at < scales.length; at++) {
                next[at] = scales[at] > 0 ? Math.sqrt(scales[at] / sum(at)) : 0;
            }
            System.arraycopy(next, 0, scales, 0, next.length);
        }

        private double sum(int at) {
            double[] sum = new double[1];
            forAround(at, (i, other) -> sum[0] += weights[AROUND * at + i] * scales[other]);
            return sum[0];
        }

        private void mean(int at, float[] after) {
            double sum = sum(at);
            double[] means = new double[stride];
            forAround(at, (i, other) -> {
                double weight = weights[AROUND * at + i] * scales[other] / sum;
                for (int value = 0; value < stride; value++) {
                    means[value] += weight * before[stride * (first + other) + value];
                }
            });
            for (int value = 0; value < stride; value++) {
                after[stride * (first + at) + value] = (float) means[value];
            }
        }

        /** Returns the mean variance of the texels around one; a single error is known no better than to a quarter. */
        private double variance(int at) {
            double[] sums = new double[2];
            forAround(at, (i, other) -> {
                double error = errors[first + other];
                sums[0] += error > 0 ? error * error : 0;
                sums[1] += error > 0 ? 1 : 0;
            });
            return sums[0] / Math.max(1, sums[1]);
        }

        /** What is done with each texel around one. */
        private interface Visit {
            void texel(int i, int other);
        }

        private void forAround(int at, Visit visit) {
            int column = at % columns;
            int row = at / columns;
            for (int y = Math.max(0, row - RADIUS); y <= Math.min(row + RADIUS, rows - 1); y++) {
                for (int x = Math.max(0, column - RADIUS); x <= Math.min(column + RADIUS, columns - 1); x++) {
                    visit.texel((y - row + RADIUS) * SIDE + x - column + RADIUS, y * columns + x);
                }
            }
        }
    }

    private double luminance(int receiver) {
        double sum = 0;
        for (int i = stride * receiver; i < stride * (receiver + 1); i += Gathered.VALUES) {
            sum += Gathered.luminance(before[i], before[i + 1], before[i + 2]);
        }
        return sum;
    }
}
