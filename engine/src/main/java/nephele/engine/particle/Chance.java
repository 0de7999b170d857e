package nephele.engine.particle;

/**
 * Random numbers by index: the same seed, index and purpose always give the same number (the finaliser of Steele, Lea
 * and Flood 2014, "Fast Splittable Pseudorandom Number Generators").
 */
final class Chance {
    private static final long GOLDEN = 0x9e3779b97f4a7c15L;
    private static final double UNIT = 0x1p-53;

    private Chance() {}

    /** Returns a number from 0 (included) to 1. */
    static double unit(long seed, long index, int purpose) {
        long z = mixed(mixed(seed * GOLDEN + index) + purpose * GOLDEN);
        return (z >>> 11) * UNIT;
    }

    /** Returns a number from −1 (included) to 1. */
    static double signed(long seed, long index, int purpose) {
        return 2 * unit(seed, index, purpose) - 1;
    }

    private static long mixed(long z) {
        long a = (z ^ z >>> 30) * 0xbf58476d1ce4e5b9L;
        long b = (a ^ a >>> 27) * 0x94d049bb133111ebL;
        return b ^ b >>> 31;
    }
}
