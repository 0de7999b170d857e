package nephele.engine.math;

import java.nio.charset.StandardCharsets;

/** A 64-bit hash of a sequence of numbers; each is mixed in by SplitMix64's finaliser (Steele, Lea and Flood 2014). */
public final class Hash64 {
    private Hash64() {}

    /** Returns the hash of the text's UTF-8 bytes. */
    public static long of(String text) {
        return of(text.getBytes(StandardCharsets.UTF_8));
    }

    /** Returns the hash of the bytes in order. */
    public static long of(byte[] content) {
        long hash = 0;
        for (byte unit : content) {
            hash = combine(hash, unit);
        }
        return hash;
    }

    /** Returns {@code hash} extended by 64 bits; the order of the calls matters. */
    public static long combine(long hash, long bits) {
        long z = (hash ^ bits) + 0x9e3779b97f4a7c15L;
        z = (z ^ (z >>> 30)) * 0xbf58476d1ce4e5b9L;
        z = (z ^ (z >>> 27)) * 0x94d049bb133111ebL;
        return z ^ (z >>> 31);
    }

    /** Adds a number by its bits. All NaNs hash alike, because NaN bit patterns depend on the processor. */
    public static long combine(long hash, double number) {
        return combine(hash, Double.doubleToLongBits(number));
    }

    public static long combine(long hash, Vec3 v) {
        return combine(combine(combine(hash, v.x()), v.y()), v.z());
    }
}
