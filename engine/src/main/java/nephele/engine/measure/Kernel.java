package nephele.engine.measure;

import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;

/**
 * The weights of a separable filter in one dimension, centred. Positive and negative weights are normalised separately.
 *
 * @param weights an odd number
 */
record Kernel(float[] weights) {
    static Kernel of(int radius, DoubleUnaryOperator weight) {
        double[] raw = new double[2 * radius + 1];
        double positive = 0;
        double negative = 0;
        for (int i = 0; i < raw.length; i++) {
            raw[i] = weight.applyAsDouble(i - radius);
            positive += Math.max(raw[i], 0);
            negative -= Math.min(raw[i], 0);
        }
        float[] weights = new float[raw.length];
        for (int i = 0; i < raw.length; i++) {
            weights[i] = (float) (raw[i] > 0 ? raw[i] / positive : raw[i] < 0 ? raw[i] / negative : 0);
        }
        return new Kernel(weights);
    }

    int radius() {
        return weights.length / 2;
    }

    /** Filters each row of {@code from}; beyond the border the border's value is repeated. */
    void alongRows(float[] from, int width, float[] to) {
        int radius = radius();
        float[] padded = new float[width + 2 * radius];
        float[] sum = new float[width];
        for (int row = 0; row < from.length; row += width) {
            Arrays.fill(padded, 0, radius, from[row]);
            System.arraycopy(from, row, padded, radius, width);
            Arrays.fill(padded, radius + width, padded.length, from[row + width - 1]);
            Arrays.fill(sum, 0);
            for (int k = 0; k < weights.length; k++) {
                addScaled(padded, k, weights[k], sum, 0, width);
            }
            System.arraycopy(sum, 0, to, row, width);
        }
    }

    /** Filters each column as {@link #alongRows}; {@code to} must not be {@code from}. */
    void alongColumns(float[] from, int width, float[] to) {
        int radius = radius();
        int height = from.length / width;
        Arrays.fill(to, 0);
        for (int row = 0; row < height; row++) {
            for (int k = 0; k < weights.length; k++) {
                int source = Math.min(Math.max(row + k - radius, 0), height - 1);
                addScaled(from, source * width, weights[k], to, row * width, width);
            }
        }
    }

    private static void addScaled(float[] from, int fromStart, float weight, float[] to, int toStart, int count) {
        for (int i = 0; i < count; i++) {
            to[toStart + i] += weight * from[fromStart + i];
        }
    }
}
