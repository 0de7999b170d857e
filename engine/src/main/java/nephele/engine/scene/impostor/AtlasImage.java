package nephele.engine.scene.impostor;

import java.util.Arrays;

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
        int[] ring = new int[0];
        boolean[] isQueued = new boolean[side * side];
        for (int n = 0; n < rings; n++) {
            ring = n == 0 ? unknown(isQueued) : unknownAround(ring, isQueued);
            float[] next = new float[ring.length];
            for (int i = 0; i < ring.length; i++) {
                next[i] = around(ring[i] % side, ring[i] / side, viewTexels);
            }
            int kept = 0;
            for (int i = 0; i < ring.length; i++) {
                values[CHANNELS * ring[i] + DEPTH] = next[i];
                if (Float.isNaN(next[i])) {
                    isQueued[ring[i]] = false;
                } else {
                    ring[kept++] = ring[i];
                }
            }
            ring = Arrays.copyOf(ring, kept);
        }
        for (int i = DEPTH; i < values.length; i += CHANNELS) {
            values[i] = Float.isNaN(values[i]) ? 0 : values[i];
        }
    }

    private int[] unknown(boolean[] isQueued) {
        int[] found = new int[isQueued.length];
        int count = 0;
        for (int i = 0; i < isQueued.length; i++) {
            if (Float.isNaN(values[CHANNELS * i + DEPTH])) {
                isQueued[i] = true;
                found[count++] = i;
            }
        }
        return Arrays.copyOf(found, count);
    }

    /** Returns the texels without a depth beside those that have just got one. */
    private int[] unknownAround(int[] ring, boolean[] isQueued) {
        int[] found = new int[8 * ring.length];
        int count = 0;
        for (int texel : ring) {
            for (int i = 0; i < 9; i++) {
                int x = texel % side + i % 3 - 1;
                int y = texel / side + i / 3 - 1;
                int at = y * side + x;
                boolean isInside = x >= 0 && x < side && y >= 0 && y < side;
                if (isInside && !isQueued[at] && Float.isNaN(values[CHANNELS * at + DEPTH])) {
                    isQueued[at] = true;
                    found[count++] = at;
                }
            }
        }
        return Arrays.copyOf(found, count);
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
