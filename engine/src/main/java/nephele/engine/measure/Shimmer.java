package nephele.engine.measure;

import java.util.List;

/** The flicker of the error along a moving picture: edges that crawl over pixels in steps shimmer. */
public final class Shimmer {
    private Shimmer() {}

    /**
     * Returns the RMS change of the error from frame to frame,
     * √(mean ((xₜ − rₜ) − (xₜ₋₁ − rₜ₋₁))²) over all channels, pixels and pairs of successive frames. An error that stays
     * does not count.
     *
     * @param reference the exact frames r, linear light
     * @param test the judged frames x, as many and of the same size
     */
    public static double of(List<LinearPicture> reference, List<LinearPicture> test) {
        if (reference.size() != test.size() || test.size() < 2) {
            throw new IllegalArgumentException("shimmer is measured between the frames of two pictures, not of "
                    + reference.size() + " and " + test.size() + " frames");
        }
        double sum = 0;
        float[] before = error(reference.get(0), test.get(0));
        for (int frame = 1; frame < test.size(); frame++) {
            float[] now = error(reference.get(frame), test.get(frame));
            for (int i = 0; i < now.length; i++) {
                double change = now[i] - before[i];
                sum += change * change;
            }
            before = now;
        }
        return Math.sqrt(sum / before.length / (test.size() - 1));
    }

    private static float[] error(LinearPicture reference, LinearPicture test) {
        reference.requireSameSize(test);
        float[] error = new float[test.rgb().length];
        for (int i = 0; i < error.length; i++) {
            error[i] = test.rgb()[i] - reference.rgb()[i];
        }
        return error;
    }
}
