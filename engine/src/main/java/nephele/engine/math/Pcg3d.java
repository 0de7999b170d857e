package nephele.engine.math;

/**
 * Three numbers of 32 random bits for three integers: M. Jarzyński and M. Olano, "Hash Functions for GPU Rendering", 2020, pcg3d.
 * A shader with the same lines produces the same bits.
 */
public record Pcg3d(int x, int y, int z) {
    public static Pcg3d of(int x, int y, int z) {
        int a = x * 1664525 + 1013904223;
        int b = y * 1664525 + 1013904223;
        int c = z * 1664525 + 1013904223;
        a += b * c;
        b += c * a;
        c += a * b;
        a ^= a >>> 16;
        b ^= b >>> 16;
        c ^= c >>> 16;
        a += b * c;
        b += c * a;
        c += a * b;
        return new Pcg3d(a, b, c);
    }

    /** Returns the upper 24 bits of a number as one in [0, 1); exact in float as well. */
    public static double unit(int bits) {
        return (bits >>> 8) * 0x1p-24;
    }
}
