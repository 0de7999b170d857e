package nephele.engine.measure;

/**
 * Detects edges and points in a picture's luminance: the magnitudes of the first and second derivatives of a Gaussian
 * with the width of an edge detector of human vision, 0.082 degrees (Andersson et al. 2020, section 4.2).
 */
final class FeatureFilter {
    private static final double WIDTH_DEGREES = 0.082;

    private final Kernel smooth;
    private final Kernel first;
    private final Kernel second;

    /**
     * The strength of edges and points at each pixel.
     *
     * @param edges 0–1
     * @param points 0–1
     */
    record Features(float[] edges, float[] points) {}

    FeatureFilter(double pixelsPerDegree) {
        double deviation = 0.5 * WIDTH_DEGREES * pixelsPerDegree;
        int radius = (int) Math.ceil(3 * deviation);
        smooth = Kernel.of(radius, x -> gaussian(x / deviation));
        first = Kernel.of(radius, x -> -x * gaussian(x / deviation));
        second = Kernel.of(radius, x -> (x * x / (deviation * deviation) - 1) * gaussian(x / deviation));
    }

    private static double gaussian(double x) {
        return Math.exp(-x * x / 2);
    }

    Features of(OpponentPicture picture) {
        float[] luminance = picture.y().clone();
        for (int i = 0; i < luminance.length; i++) {
            luminance[i] = (luminance[i] + 16) / 116;
        }
        int width = picture.width();
        return new Features(lengths(luminance, width, first), lengths(luminance, width, second));
    }

    private float[] lengths(float[] luminance, int width, Kernel derivative) {
        float[] rows = new float[luminance.length];
        float[] across = new float[luminance.length];
        float[] along = new float[luminance.length];
        derivative.alongRows(luminance, width, rows);
        smooth.alongColumns(rows, width, along);
        smooth.alongRows(luminance, width, rows);
        derivative.alongColumns(rows, width, across);
        for (int i = 0; i < along.length; i++) {
            along[i] = (float) Math.sqrt(along[i] * along[i] + across[i] * across[i]);
        }
        return along;
    }
}
