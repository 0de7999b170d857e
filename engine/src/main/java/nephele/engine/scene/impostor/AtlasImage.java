package nephele.engine.scene.impostor;

/**
 * One size of an atlas in linear numbers. Channels of a texel: colour times coverage, coverage, mean normal times
 * coverage, and depth in radii towards the viewer.
 */
final class AtlasImage {
    static final int CHANNELS = 8;
    static final int ALPHA = 3;
    static final int DEPTH = 7;
    private static final float UNKNOWN = Float.NaN;

    private final int side;
    private final float[] values;

    AtlasImage(int side) {
        this.side = side;
        values = new float[CHANNELS * side * side];
    }

    int side() {
        return side;
    }

    float value(int x, int y, int channel) {
        return values[CHANNELS * (y * side + x) + channel];
    }

    /** Sets a texel. @param sums of {@code count} samples of {@code all} */
    void put(int x, int y, float[] sums, int count, int all) {
        int at = CHANNELS * (y * side + x);
        for (int i = 0; i < DEPTH; i++) {
            values[at + i] = sums[i] / all;
        }
        values[at + ALPHA] = (float) count / all;
        values[at + DEPTH] = count == 0 ? UNKNOWN : sums[DEPTH] / count;
    }

    /** Gives texels without a depth the mean of their neighbours' that have one, ring by ring, within each view. */
    void spreadDepths(int viewTexels, int rings) {
        for (int ring = 0; ring < rings; ring++) {
            float[] next = new float[side * side];
            for (int i = 0; i < next.length; i++) {
                float own = values[CHANNELS * i + DEPTH];
                next[i] = Float.isNaN(own) ? around(i % side, i / side, viewTexels) : own;
            }
            for (int i = 0; i < next.length; i++) {
                values[CHANNELS * i + DEPTH] = next[i];
            }
        }
        for (int i = DEPTH; i < values.length; i += CHANNELS) {
            values[i] = Float.isNaN(values[i]) ? 0 : values[i];
        }
    }

    private float around(int x, int y, int viewTexels) {
        float sum = 0;
        int count = 0;
        for (int i = 0; i < 9; i++) {
            int column = x + i % 3 - 1;
            int row = y + i / 3 - 1;
            boolean isInView = column >= 0
                    && row >= 0
                    && column / viewTexels == x / viewTexels
                    && row / viewTexels == y / viewTexels;
            float depth = isInView ? value(column, row, DEPTH) : UNKNOWN;
            if (!Float.isNaN(depth)) {
                sum += depth;
                count++;
            }
        }
        return count == 0 ? UNKNOWN : sum / count;
    }

    /** Returns the mean of each four texels. */
    AtlasImage halved() {
        AtlasImage half = new AtlasImage(Math.max(1, side / 2));
        for (int i = 0; i < half.side * half.side; i++) {
            int x = 2 * (i % half.side);
            int y = 2 * (i / half.side);
            float weights = 0;
            float depth = 0;
            for (int k = 0; k < 4; k++) {
                int from = CHANNELS * ((y + k / 2) * side + x + k % 2);
                for (int channel = 0; channel < DEPTH; channel++) {
                    half.values[CHANNELS * i + channel] += values[from + channel] / 4;
                }
                // Uncovered texels count little: their depth is a guess.
                float weight = values[from + ALPHA] + 1e-3f;
                weights += weight;
                depth += weight * values[from + DEPTH];
            }
            half.values[CHANNELS * i + DEPTH] = depth / weights;
        }
        return half;
    }
}
