package nephele.engine.measure;

import java.util.Arrays;
import java.util.stream.IntStream;

/** FLIP of radiance: the maximum of its errors over a range of exposures (Andersson et al. 2021). */
public final class HdrFlip {
    /** Narkowicz' fit of the ACES filmic curve (2015), at 0.6 of the exposure: the tone mapper of HDR-FLIP. */
    private static final double EXPOSURE = 0.6;

    private static final double A2 = 2.51 * EXPOSURE * EXPOSURE;
    private static final double A1 = 0.03 * EXPOSURE;
    private static final double B2 = 2.43 * EXPOSURE * EXPOSURE;
    private static final double B1 = 0.59 * EXPOSURE;
    private static final double B0 = 0.14;

    private HdrFlip() {}

    /** Returns the error of each pixel over the exposures of the reference. */
    public static ErrorMap of(LinearPicture reference, LinearPicture test) {
        return of(reference, test, ExposureRange.of(reference));
    }

    /** Returns the error of each pixel over given exposures, so that several references can be compared. */
    public static ErrorMap of(LinearPicture reference, LinearPicture test, ExposureRange exposures) {
        reference.requireSameSize(test);
        return IntStream.range(0, exposures.count())
                .parallel()
                .mapToObj(i ->
                        Flip.ofDisplayed(displayed(reference, exposures.stops(i)), displayed(test, exposures.stops(i))))
                .reduce(ErrorMap::greater)
                .orElseThrow();
    }

    private static LinearPicture displayed(LinearPicture radiance, double stops) {
        double exposure = Math.pow(2, stops);
        float[] rgb = radiance.rgb().clone();
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = (float) toneMapped(exposure * Math.max(rgb[i], 0));
        }
        return new LinearPicture(radiance.width(), radiance.height(), rgb);
    }

    static double toneMapped(double radiance) {
        double mapped = radiance * (A2 * radiance + A1) / (radiance * (B2 * radiance + B1) + B0);
        return Math.min(Math.max(mapped, 0), 1);
    }

    /** Returns the greater of the two radiances that are mapped to {@code displayed}, which is below 1. */
    static double inverse(double displayed) {
        double a = A2 - displayed * B2;
        double b = A1 - displayed * B1;
        double c = -displayed * B0;
        return (-b + Math.sqrt(b * b - 4 * a * c)) / (2 * a);
    }

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
                throw new IllegalArgumentException(
                        "exposures go from the lower to the higher one in at least two steps");
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
            double bright = inverse(BRIGHTEST);
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
}
