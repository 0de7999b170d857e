package nephele.engine.measure;

/**
 * The difference that an observer sees when flipping between two pictures: Andersson, Nilsson, Akenine-Möller,
 * Oskarsson, Åström and Fairchild, "FLIP: A Difference Evaluator for Alternating Images", 2020. Symmetric except for
 * rounding; 0 is equal, 1 is black against white.
 */
public final class Flip {
    /** A display 0.7 m wide with 3 840 pixels, seen from 0.7 m: the authors' default. */
    public static final double PIXELS_PER_DEGREE = 0.7 * (3840 / 0.7) * (Math.PI / 180);

    /** Exponent that compresses large colour differences. */
    private static final double COLOUR_EXPONENT = 0.7;

    /** Differences below this fraction of the greatest one are mapped to {@link #COLOUR_TARGET} of the range. */
    private static final double COLOUR_KNEE = 0.4;

    private static final double COLOUR_TARGET = 0.95;
    private static final double FEATURE_EXPONENT = 0.5;

    private static final ContrastFilter CONTRAST = new ContrastFilter(PIXELS_PER_DEGREE);
    private static final FeatureFilter FEATURES = new FeatureFilter(PIXELS_PER_DEGREE);
    private static final double GREATEST_COLOUR_DIFFERENCE = greatestColourDifference();

    private Flip() {}

    /**
     * Returns the error of each pixel.
     *
     * @param reference linear values from 0 to 1, as emitted by a display
     * @param test likewise, of the same size
     * @throws IllegalArgumentException if the sizes differ
     */
    public static ErrorMap ofDisplayed(LinearPicture reference, LinearPicture test) {
        reference.requireSameSize(test);
        var exact = OpponentPicture.of(reference);
        var tried = OpponentPicture.of(test);
        var exactFeatures = FEATURES.of(exact);
        var triedFeatures = FEATURES.of(tried);
        CONTRAST.apply(exact);
        CONTRAST.apply(tried);
        float[] exactLab = exact.huntLab();
        float[] triedLab = tried.huntLab();
        float[] error = new float[reference.pixels()];
        for (int i = 0; i < error.length; i++) {
            double colour = colourError(exactLab, triedLab, 3 * i);
            double feature = featureError(exactFeatures, triedFeatures, i);
            error[i] = (float) Math.pow(colour, 1 - feature);
        }
        return new ErrorMap(reference.width(), reference.height(), error);
    }

    /** Returns the HyAB distance (Abasi, Tehran and Fairchild 2020), compressed and mapped to 0–1. */
    private static double colourError(float[] exact, float[] tried, int at) {
        double lightness = Math.abs(exact[at] - tried[at]);
        double difference = Math.pow(
                lightness + Math.hypot(exact[at + 1] - tried[at + 1], exact[at + 2] - tried[at + 2]), COLOUR_EXPONENT);
        double knee = COLOUR_KNEE * GREATEST_COLOUR_DIFFERENCE;
        return difference < knee
                ? COLOUR_TARGET / knee * difference
                : COLOUR_TARGET + (difference - knee) / (GREATEST_COLOUR_DIFFERENCE - knee) * (1 - COLOUR_TARGET);
    }

    private static double featureError(FeatureFilter.Features exact, FeatureFilter.Features tried, int pixel) {
        double edges = Math.abs(exact.edges()[pixel] - tried.edges()[pixel]);
        double points = Math.abs(exact.points()[pixel] - tried.points()[pixel]);
        return Math.pow(Math.max(edges, points) / Math.sqrt(2), FEATURE_EXPONENT);
    }

    /** Returns the compressed distance of green and blue, the most different colours of a display. */
    private static double greatestColourDifference() {
        double[] green = lab(0, 1, 0);
        double[] blue = lab(0, 0, 1);
        double lightness = Math.abs(green[0] - blue[0]);
        return Math.pow(lightness + Math.hypot(green[1] - blue[1], green[2] - blue[2]), COLOUR_EXPONENT);
    }

    private static double[] lab(double red, double green, double blue) {
        double[] lab = new double[3];
        Colorimetry.huntLab(
                Colorimetry.relativeX(red, green, blue),
                Colorimetry.relativeY(red, green, blue),
                Colorimetry.relativeZ(red, green, blue),
                lab);
        return lab;
    }
}
