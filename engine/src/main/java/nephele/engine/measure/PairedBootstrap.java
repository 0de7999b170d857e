package nephele.engine.measure;

import java.util.Arrays;
import java.util.SplittableRandom;

/**
 * Confidence intervals for medians by resampling (Efron 1979, percentile method). The generator is seeded, so equal
 * numbers give equal intervals. Paired measurements are drawn together, so that a disturbance of both sides cancels.
 */
public final class PairedBootstrap {
    public static final double CONFIDENCE = 0.95;

    private final int resamples;
    private final long seed;

    public PairedBootstrap(int resamples, long seed) {
        if (resamples < 100) {
            throw new IllegalArgumentException("an interval of 95 % needs at least 100 resamples");
        }
        this.resamples = resamples;
        this.seed = seed;
    }

    /** Returns a bootstrap of 10 000 resamples, the usual number. */
    public static PairedBootstrap standard() {
        return new PairedBootstrap(10_000, 1);
    }

    /** Returns the interval of the median of tried[i] / base[i]. */
    public Interval ratio(double[] base, double[] tried) {
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
        return median(ratios);
    }

    /** Returns the interval of the median of single values. */
    public Interval median(double[] values) {
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
