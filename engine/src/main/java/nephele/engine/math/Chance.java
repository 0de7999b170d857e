package nephele.engine.math;

/**
 * Random numbers by index: the same seed, index and purpose always give the same number (the finaliser of Steele, Lea
 * and Flood 2014, "Fast Splittable Pseudorandom Number Generators").
 */
public final class Chance {
    private static final long GOLDEN = 0x9e3779b97f4a7c15L;
    private static final double UNIT = 0x1p-53;

    private Chance() {}

    /** Returns the dice of an index: its numbers for different purposes are independent. */
    public static long dice(long seed, long index) {
        return mixed(seed * GOLDEN + index);
    }

    /** Returns a number from 0 (included) to 1. */
    public static double unit(long dice, int purpose) {
        return (mixed(dice + purpose * GOLDEN) >>> 11) * UNIT;
    }

    /** Returns a number from −1 (included) to 1. */
    public static double signed(long dice, int purpose) {
        return 2 * unit(dice, purpose) - 1;
    }

    private static long mixed(long z) {
        long a = (z ^ z >>> 30) * 0xbf58476d1ce4e5b9L;
        long b = (a ^ a >>> 27) * 0x94d049bb133111ebL;
        return b ^ b >>> 31;
    }
}
