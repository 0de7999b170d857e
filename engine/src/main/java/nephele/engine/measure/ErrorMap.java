package nephele.engine.measure;

import java.util.Arrays;

/**
 * An error for each pixel.
 *
 * @param error 0 (equal) to 1; rows in the order of the compared pictures
 */
public record ErrorMap(int width, int height, float[] error) {
    /** Returns the mean error of all pixels. */
    public double mean() {
        double sum = 0;
        for (float value : error) {
            sum += value;
        }
        return sum / error.length;
    }

    /**
     * Returns a quantile of the error.
     *
     * @param fraction of the pixels that have at most this error, 0–1
     */
    public double quantile(double fraction) {
        float[] sorted = error.clone();
        Arrays.sort(sorted);
        return sorted[(int) Math.min(sorted.length - 1L, (long) (fraction * sorted.length))];
    }

    /** Returns the maximum of both maps for each pixel. */
    ErrorMap greater(ErrorMap other) {
        float[] greater = new float[error.length];
        for (int i = 0; i < greater.length; i++) {
            greater[i] = Math.max(error[i], other.error[i]);
        }
        return new ErrorMap(width, height, greater);
    }
}
