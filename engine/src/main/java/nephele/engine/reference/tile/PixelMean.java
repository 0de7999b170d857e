package nephele.engine.reference.tile;

import org.joml.Vector3d;

/**
 * The mean of a pixel's samples and the variance of this mean, from the means of {@value #BATCHES} batches of successive
 * samples whose numbers differ by at most one. Where samples form a low-discrepancy pattern the mean is better than the
 * variance says. Reused for each pixel by one thread.
 */
public final class PixelMean {
    public static final int BATCHES = 32;

    private final int samples;
    private final Vector3d sum = new Vector3d();
    private final Vector3d[] sums = new Vector3d[BATCHES];
    private int added;

    /** @param samples of each pixel */
    public PixelMean(int samples) {
        this.samples = samples;
        for (int batch = 0; batch < BATCHES; batch++) {
            sums[batch] = new Vector3d();
        }
    }

    /** Returns true if there are enough samples for a variance. */
    public boolean hasVariance() {
        return samples >= BATCHES;
    }

    /** Begins another pixel. */
    public void reset() {
        added = 0;
        sum.zero();
        for (Vector3d batch : sums) {
            batch.zero();
        }
    }

    /** Adds the next sample, RGB. */
    public void add(Vector3d sample) {
        sum.add(sample);
        if (hasVariance()) {
            // Batch b has the samples from first(b) to first(b + 1).
            sums[(int) (((added + 1L) * BATCHES - 1) / samples)].add(sample);
        }
        added++;
    }

    private int first(int batch) {
        return (int) ((long) batch * samples / BATCHES);
    }

    /** Puts the mean of the samples. */
    public void putMean(float[] rgb, int at) {
        rgb[at] = (float) (sum.x / samples);
        rgb[at + 1] = (float) (sum.y / samples);
        rgb[at + 2] = (float) (sum.z / samples);
    }

    /** Puts the variance of the mean: Σ n_b (m_b − m)² / ((B − 1) n) for batches of n_b samples with means m_b. */
    public void putVariance(float[] variance, int at) {
        for (int channel = 0; channel < 3; channel++) {
            double mean = sum.get(channel) / samples;
            double squares = 0;
            for (int batch = 0; batch < BATCHES; batch++) {
                int count = first(batch + 1) - first(batch);
                double off = sums[batch].get(channel) / count - mean;
                squares += count * off * off;
            }
            variance[at + channel] = (float) (squares / (BATCHES - 1) / samples);
        }
    }
}
