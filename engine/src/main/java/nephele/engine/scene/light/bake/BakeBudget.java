package nephele.engine.scene.light.bake;

import java.util.function.IntConsumer;

/**
 * The budget of a bake, so that it ends within seconds for any level. Box tests are counted for a sample of the points;
 * rays are omitted if all points would need more than {@link #MOST_BOX_TESTS}.
 */
final class BakeBudget implements Occluders.Sight {
    /** Takes one or two seconds on one core. */
    static final long MOST_BOX_TESTS = 150_000_000L;

    /** Each further such number of items adds the cost of a cached box test: the tree leaves the processor's caches. */
    private static final double CACHED_ITEMS = 25_000;

    private static final int SAMPLES = 128;

    private final Occluders occluders;
    private long boxTests;

    BakeBudget(Occluders occluders) {
        this.occluders = occluders;
    }

    @Override
    public boolean isOccluded(double[] o, double[] d, int except) {
        boolean[] hit = new boolean[1];
        boxTests += occluders.boxTests(o, d, except, hit);
        return hit[0];
    }

    /**
     * Returns the divisor for the number of rays of each of {@code places}, a power of two.
     *
     * @param from number of items from which the sample is taken
     * @param measure casts the rays of one point of an item, with this as the sight
     */
    int divisor(int from, int places, IntConsumer measure) {
        int samples = Math.min(from, SAMPLES);
        for (int i = 0; i < samples; i++) {
            measure.accept((int) ((i + 0.5) * from / samples));
        }
        double dearer = 1 + occluders.items() / CACHED_ITEMS;
        double all = dearer * boxTests * places / Math.max(samples, 1);
        int divisor = 1;
        while (all > (double) divisor * MOST_BOX_TESTS) {
            divisor *= 2;
        }
        return divisor;
    }
}
