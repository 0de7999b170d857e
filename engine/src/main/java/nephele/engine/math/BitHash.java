package nephele.engine.math;

import java.nio.charset.StandardCharsets;

/** Joins numbers to a 64-bit hash, in order: the finaliser of SplitMix64 (Steele, Lea and Flood 2014) after each. */
public final class BitHash {
    private BitHash() {}

    /** Of a text, for names and keys. */
    public static long of(String text) {
        return of(text.getBytes(StandardCharsets.UTF_8));
    }

    public static long of(byte[] content) {
        long hash = 0;
        for (byte unit : content) {
            hash = join(hash, unit);
        }
        return hash;
    }

    public static long join(long hash, long bits) {
        long z = (hash ^ bits) + 0x9e3779b97f4a7c15L;
        z = (z ^ (z >>> 30)) * 0xbf58476d1ce4e5b9L;
        z = (z ^ (z >>> 27)) * 0x94d049bb133111ebL;
        return z ^ (z >>> 31);
    }

    /** NaN has one pattern here: its others depend on the processor. */
    public static long join(long hash, double number) {
        return join(hash, Double.doubleToLongBits(number));
    }

    public static long join(long hash, Vec3 v) {
        return join(join(join(hash, v.x()), v.y()), v.z());
    }
}
