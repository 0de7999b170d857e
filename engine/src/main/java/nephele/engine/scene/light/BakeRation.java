package nephele.engine.scene.light;

import java.util.function.IntConsumer;

/**
 * How much of the work of a bake is done, so that the light of any level is there within seconds. Box tests are counted
 * for a sample of the places; rays are left out where all places would take more of them than {@link #MOST_BOX_TESTS}.
 */
final class BakeRation implements SkySight {
    /** One or two seconds of a core. */
    static final long MOST_BOX_TESTS = 150_000_000L;

    /** As many items again make a box test as much dearer: the tree leaves the processor's caches. */
    private static final double CACHED_ITEMS = 25_000;

    private static final int SAMPLES = 128;

    private final Occluders occluders;
    private long boxTests;

    BakeRation(Occluders occluders) {
        this.occluders = occluders;
    }

    @Override
    public boolean isOccluded(double[] o, double[] d, int except) {
        boolean[] hit = new boolean[1];
        boxTests += occluders.boxTests(o, d, except, hit);
        return hit[0];
    }

    /**
     * By how much the rays of each of {@code places} are to be divided: a power of two.
     *
     * @param from as many items as the sample may be taken from
     * @param measure casts the rays of a place of one item, with this as the sight
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
