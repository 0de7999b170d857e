package nephele.engine.measure;

import java.util.Arrays;
import java.util.SplittableRandom;

/**
 * An estimate with its confidence interval; that of a median by resampling (Efron 1979, percentile method). The generator
 * is seeded, so equal numbers give equal intervals.
 *
 * @param low at most {@code estimate}
 * @param high at least {@code estimate}
 */
public record Interval(double low, double estimate, double high) {
    private static final double CONFIDENCE = 0.95;

    /** The usual number. */
    private static final int RESAMPLES = 10_000;

    private static final long SEED = 1;

    /**
     * Returns the interval of the median of tried[i] / base[i]: paired measurements are drawn together, so that a
     * disturbance of both sides cancels.
     */
    public static Interval ofRatio(double[] base, double[] tried) {
        return ofMedian(ratios(base, tried));
    }

    /** Returns the interval of the median of single values. */
    public static Interval ofMedian(double[] values) {
        return ofMedian(values, RESAMPLES, SEED);
    }

    private static double[] ratios(double[] base, double[] tried) {
        if (base.length != tried.length) {
            throw new IllegalArgumentException(base.length + " and " + tried.length + " measurements are not paired");
        }
        double[] ratios = new double[base.length];
        for (int i = 0; i < ratios.length; i++) {
            if (!(base[i] > 0)) {
                throw new IllegalArgumentException("a ratio needs a positive base, not " + base[i]);
            }
            ratios[i] = tried[i] / base[i];
        }
        return ratios;
    }

    /** @param resamples at least 100 */
    static Interval ofMedian(double[] values, int resamples, long seed) {
        if (values.length == 0) {
            throw new IllegalArgumentException("no measurement, no interval");
        }
        var random = new SplittableRandom(seed);
        double[] medians = new double[resamples];
        double[] drawn = new double[values.length];
        for (int i = 0; i < resamples; i++) {
            for (int j = 0; j < drawn.length; j++) {
                drawn[j] = values[random.nextInt(values.length)];
            }
            medians[i] = middle(drawn);
        }
        Arrays.sort(medians);
        int tail = (int) ((1 - CONFIDENCE) / 2 * resamples);
        double estimate = middle(values.clone());
        return new Interval(
                Math.min(medians[tail], estimate), estimate, Math.max(medians[resamples - 1 - tail], estimate));
    }

    private static double middle(double[] values) {
        Arrays.sort(values);
        int half = values.length / 2;
        return values.length % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
    }
}
