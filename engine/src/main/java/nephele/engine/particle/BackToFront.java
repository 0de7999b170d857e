package nephele.engine.particle;

import java.util.Arrays;

/**
 * The order of particles from the farthest to the nearest; those at the same quantised distance keep their order. A
 * radix sort in two passes of 11 bits over the upper 22 bits of the squared distance's 31, which separates distances that
 * differ by a 30,000th.
 */
public final class BackToFront {
    private static final int DIGIT_BITS = 11;
    private static final int DIGITS = 1 << DIGIT_BITS;
    private static final int DROPPED_BITS = 31 - 2 * DIGIT_BITS;

    private int[] keys = new int[0];
    private int[] items = new int[0];
    private int[] between = new int[0];
    private int[] order = new int[0];
    private final int[] low = new int[DIGITS];
    private final int[] high = new int[DIGITS];
    private int count;

    /** Begins a list of at most {@code most} particles. */
    public void begin(int most) {
        count = 0;
        if (keys.length < most) {
            keys = new int[most];
            items = new int[most];
            between = new int[most];
            order = new int[most];
        }
    }

    /**
     * Adds a particle.
     *
     * @param squaredDistance finite and not negative
     */
    public void add(int particle, float squaredDistance) {
        keys[count] = ~(Float.floatToRawIntBits(squaredDistance) >>> DROPPED_BITS);
        items[count] = particle;
        count++;
    }

    /** Sorts what was added. */
    public void sort() {
        Arrays.fill(low, 0);
        Arrays.fill(high, 0);
        for (int i = 0; i < count; i++) {
            low[keys[i] & DIGITS - 1]++;
            high[keys[i] >>> DIGIT_BITS & DIGITS - 1]++;
        }
        startsOf(low);
        startsOf(high);
        for (int i = 0; i < count; i++) {
            between[low[keys[i] & DIGITS - 1]++] = i;
        }
        for (int i = 0; i < count; i++) {
            int entry = between[i];
            order[high[keys[entry] >>> DIGIT_BITS & DIGITS - 1]++] = items[entry];
        }
    }

    private static void startsOf(int[] counts) {
        int sum = 0;
        for (int i = 0; i < DIGITS; i++) {
            int here = counts[i];
            counts[i] = sum;
            sum += here;
        }
    }

    public int count() {
        return count;
    }

    /** Returns the particle at a place of the order; 0 is the farthest. */
    public int at(int place) {
        return order[place];
    }
}
