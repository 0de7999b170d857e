package nephele.engine.measure;

/** Error measures of radiance that FLIP does not show: squared errors and bias of the mean. */
public final class ImageError {
    /** Limits the weight of black reference pixels; in squared radiance. */
    private static final double FLOOR = 1e-2;

    private ImageError() {}

    /**
     * Returns the mean of (test − reference)² / (reference² + 0.01) over pixels and channels (Rousselle et al. 2011).
     */
    public static double relativeSquared(LinearPicture reference, LinearPicture test) {
        reference.requireSameSize(test);
        double sum = 0;
        for (int i = 0; i < reference.rgb().length; i++) {
            double exact = reference.rgb()[i];
            double difference = test.rgb()[i] - exact;
            sum += difference * difference / (exact * exact + FLOOR);
        }
        return sum / reference.rgb().length;
    }

    /** Returns the ratio of the mean luminances of test and reference, minus 1; 0 if both are black. */
    public static double meanBias(LinearPicture reference, LinearPicture test) {
        reference.requireSameSize(test);
        double exact = meanLuminance(reference);
        double tried = meanLuminance(test);
        return exact == tried ? 0 : tried / exact - 1;
    }

    /**
     * Returns √(mean (test − reference)²) over the channels of some pixels; 0 if there are none.
     *
     * @param counts for each pixel whether it counts
     */
    public static double rootMeanSquare(LinearPicture reference, LinearPicture test, boolean[] counts) {
        reference.requireSameSize(test);
        double sum = 0;
        int values = 0;
        for (int i = 0; i < reference.rgb().length; i++) {
            if (counts[i / 3]) {
                double difference = test.rgb()[i] - reference.rgb()[i];
                sum += difference * difference;
                values++;
            }
        }
        return values == 0 ? 0 : Math.sqrt(sum / values);
    }

    private static double meanLuminance(LinearPicture picture) {
        double sum = 0;
        for (int i = 0; i < picture.pixels(); i++) {
            sum += picture.luminance(i);
        }
        return sum / picture.pixels();
    }
}
