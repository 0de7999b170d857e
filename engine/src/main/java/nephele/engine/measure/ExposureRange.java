package nephele.engine.measure;

import java.util.Arrays;

/**
 * Exposures under which a picture of high dynamic range is looked at: Andersson, Nilsson, Shirley and Akenine-Möller,
 * "Visualizing Errors in Rendered High Dynamic Range Images", 2021, section 3.
 *
 * @param startStops at which the brightest pixel is just below white
 * @param stopStops at which the median pixel is, the upper one of two as in the authors' evaluator
 * @param count at least 2, evenly spaced
 */
public record ExposureRange(double startStops, double stopStops, int count) {
    /** Of white: what the tone curve makes of the brightest pixel. */
    private static final double BRIGHTEST = 0.85;

    /** What is darker counts as this dark: the resolution of a float at 1. */
    private static final double DARKEST = 0x1p-23;

    public ExposureRange {
        if (!(startStops <= stopStops) || count < 2) {
            throw new IllegalArgumentException("exposures go from the lower to the higher one in at least two steps");
        }
    }

    /** Depends on the reference alone. */
    public static ExposureRange of(LinearPicture reference) {
        double[] luminances = new double[reference.pixels()];
        for (int i = 0; i < luminances.length; i++) {
            luminances[i] = reference.luminance(i);
        }
        Arrays.sort(luminances);
        double median = luminances[luminances.length / 2];
        double bright = ToneCurve.inverse(BRIGHTEST);
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
