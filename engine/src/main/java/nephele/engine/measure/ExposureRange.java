package nephele.engine.measure;

import java.util.Arrays;

/**
 * The exposures at which high-dynamic-range pictures are compared: Andersson, Nilsson, Shirley and Akenine-Möller,
 * "Visualizing Errors in Rendered High Dynamic Range Images", 2021, section 3.
 *
 * @param startStops exposure in stops at which the brightest pixel is just below white
 * @param stopStops likewise of the median pixel, the upper one of two as in the authors' evaluator
 * @param count at least 2, evenly spaced
 */
public record ExposureRange(double startStops, double stopStops, int count) {
    /** Tone-mapped value of the brightest pixel, relative to white. */
    private static final double BRIGHTEST = 0.85;

    /** Lower bound of luminances: the resolution of a float at 1. */
    private static final double DARKEST = 0x1p-23;

    public ExposureRange {
        if (!(startStops <= stopStops) || count < 2) {
            throw new IllegalArgumentException("exposures go from the lower to the higher one in at least two steps");
        }
    }

    /** Returns the exposures for a reference; they do not depend on the compared picture. */
    public static ExposureRange of(LinearPicture reference) {
        double[] luminances = new double[reference.pixels()];
        for (int i = 0; i < luminances.length; i++) {
            luminances[i] = reference.luminance(i);
        }
        Arrays.sort(luminances);
        double median = luminances[luminances.length / 2];
        double bright = DisplayToneCurve.inverse(BRIGHTEST);
        double start = log2(bright / Math.max(luminances[luminances.length - 1], DARKEST));
        double stop = Math.max(start, log2(bright / Math.max(median, DARKEST)));
        return new ExposureRange(start, stop, Math.max(2, (int) Math.ceil(stop - start)));
    }

    double stops(int index) {
        return startStops + index * (stopStops - startStops) / (count - 1);
    }

    private static double log2(double value) {
        return Math.log(value) / Math.log(2);
    }
}
