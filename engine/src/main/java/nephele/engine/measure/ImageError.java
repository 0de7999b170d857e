package nephele.engine.measure;

/** Errors of radiance that FLIP hides: its energy and its mean. */
public final class ImageError {
    /** Keeps black pixels of the reference from deciding alone, in squared radiance. */
    private static final double FLOOR = 1e-2;

    private ImageError() {}

    /** Mean of (test − reference)² / (reference² + 0.01) over pixels and channels (Rousselle et al. 2011). */
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

    /** Mean luminance of the test over that of the reference, minus 1; 0 where both are black. */
    public static double meanBias(LinearPicture reference, LinearPicture test) {
        reference.requireSameSize(test);
        double exact = meanLuminance(reference);
        double tried = meanLuminance(test);
        return exact == tried ? 0 : tried / exact - 1;
    }

    private static double meanLuminance(LinearPicture picture) {
        double sum = 0;
        for (int i = 0; i < picture.pixels(); i++) {
            sum += picture.luminance(i);
        }
        return sum / picture.pixels();
    }
}
