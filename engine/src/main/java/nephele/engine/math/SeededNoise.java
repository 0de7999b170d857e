package nephele.engine.math;

/**
 * A noise function in integer arithmetic, so that a shader with the same lines produces the same bits. The hash is {@link
 * Pcg3d}. The lattice repeats after 2³² cells.
 */
public final class SeededNoise {
    private final int seed;

    /** Creates the noise of a seed; equal seeds give equal noise. */
    public SeededNoise(int seed) {
        this.seed = seed;
    }

    /** Returns 32 random bits for a lattice cell. */
    public int bits(int x, int y, int z) {
        return Pcg3d.of(x ^ seed, y + seed * 0x9E3779B9, z).x();
    }

    /** Returns a number in [0, 1) from the upper 24 bits of a lattice cell; exact in float as well. */
    public double unit(int x, int y, int z) {
        return Pcg3d.unit(bits(x, y, z));
    }

    /** Returns trilinear value noise with a smooth step, in [0, 1); 0 if a coordinate is not finite. */
    public double at(double x, double y, double z) {
        if (!Double.isFinite(x + y + z)) {
            return 0;
        }
        int i = cell(x);
        int j = cell(y);
        int k = cell(z);
        double u = smooth(fraction(x));
        double v = smooth(fraction(y));
        double w = smooth(fraction(z));
        double near = mix(row(i, j, k, u), row(i, j + 1, k, u), v);
        double far = mix(row(i, j, k + 1, u), row(i, j + 1, k + 1, u), v);
        return mix(near, far, w);
    }

    private double row(int i, int j, int k, double u) {
        return mix(unit(i, j, k), unit(i + 1, j, k), u);
    }

    /** Returns the lattice cell of a coordinate, modulo 2³²; a direct cast from double to int would saturate. */
    static int cell(double coordinate) {
        double floor = Math.floor(coordinate);
        return Math.abs(floor) < 0x1p53 ? (int) (long) floor : 0;
    }

    /** Returns the fractional part in [0, 1), although −10⁻²⁰ − floor(−10⁻²⁰) rounds to 1. */
    static double fraction(double coordinate) {
        return Math.min(coordinate - Math.floor(coordinate), Math.nextDown(1.0));
    }

    private static double smooth(double t) {
        return t * t * (3 - 2 * t);
    }

    private static double mix(double a, double b, double t) {
        return a + (b - a) * t;
    }
}
