package nephele.engine.cloud.octave;

import nephele.engine.math.Pcg3d;

/**
 * An octave of noise in the plane that goes from one generation to the next. Its cells are counted modulo 2³², those of the
 * source's noise modulo its number of texels.
 *
 * @param isSmooth gradient noise; otherwise the source's white noise, enlarged bilinearly
 * @param index 0 for the widest
 * @param cellMetres edge of a cell
 * @param weight in the sum of octaves
 * @param generationSeconds after which it is another one; 0 if it stays
 * @param seed of smooth noise
 */
public record NoiseOctave(
        boolean isSmooth, int index, double cellMetres, double weight, double generationSeconds, long seed) {
    /** Texels along each side of the widest octave of the source. */
    private static final int SOURCE_TEXELS = 32;
    /** Between successive octaves of smooth noise, so that their cells do not lie on top of each other, radians. */
    private static final double TURN = 0.65;

    private static final double GENERATIONS = 0x1p32;

    public double cosine() {
        return isSmooth ? Math.cos(TURN * index) : 1;
    }

    public double sine() {
        return isSmooth ? Math.sin(TURN * index) : 0;
    }

    /** Returns a bit mask of the cells before they repeat. */
    public int mask() {
        return isSmooth ? -1 : (SOURCE_TEXELS << index) - 1;
    }

    /** Returns a place in cells along the octave's first axis. */
    public double u(double x, double z) {
        return (cosine() * x - sine() * z) / cellMetres;
    }

    public double v(double x, double z) {
        return (sine() * x + cosine() * z) / cellMetres;
    }

    /** Returns the number of a cell, modulo 2³². */
    public static int cell(double coordinate) {
        double floor = Math.floor(coordinate);
        return Math.abs(floor) < 0x1p53 ? (int) (long) floor : 0;
    }

    /** Returns the number of the generation that fades, modulo 2³². */
    public int generation(double seconds) {
        return generationSeconds > 0 ? cell(Math.floor(seconds / generationSeconds) % GENERATIONS) : 0;
    }

    private double fraction(double seconds) {
        double passed = generationSeconds > 0 ? seconds / generationSeconds : 0;
        return passed - Math.floor(passed);
    }

    /** Returns the weight of the generation that fades. */
    public double fading(double seconds) {
        double fraction = fraction(seconds);
        return isSmooth ? Math.cos(Math.PI / 2 * eased(fraction)) : 1 - fraction;
    }

    /** Returns that of the generation that comes. */
    public double coming(double seconds) {
        double fraction = fraction(seconds);
        return isSmooth ? Math.sin(Math.PI / 2 * eased(fraction)) : fraction;
    }

    private static double eased(double t) {
        return t * t * (3 - 2 * t);
    }

    /** Returns the number that stands for a generation in the hash. */
    public int key(int generation) {
        return isSmooth
                ? Pcg3d.of(generation, index, (int) (seed ^ seed >>> 32)).x()
                : generation;
    }

    /** Returns the value at a place, −1 to 1, without the weight. */
    public double at(double x, double z, double seconds) {
        double u = u(x, z);
        double v = v(x, z);
        int generation = generation(seconds);
        double coming = coming(seconds);
        double value = fading(seconds) * at(u, v, key(generation));
        return coming == 0 ? value : value + coming * at(u, v, key(generation + 1));
    }

    private double at(double u, double v, int key) {
        int i = cell(u);
        int j = cell(v);
        double fu = u - Math.floor(u);
        double fv = v - Math.floor(v);
        double a = corner(i, j, fu, fv, key);
        double b = corner(i + 1, j, fu - 1, fv, key);
        double c = corner(i, j + 1, fu, fv - 1, key);
        double d = corner(i + 1, j + 1, fu - 1, fv - 1, key);
        double su = isSmooth ? quintic(fu) : fu;
        double sv = isSmooth ? quintic(fv) : fv;
        double low = a + su * (b - a);
        double high = c + su * (d - c);
        return low + sv * (high - low);
    }

    private static double quintic(double t) {
        return t * t * t * (t * (6 * t - 15) + 10);
    }

    private double corner(int i, int j, double du, double dv, int key) {
        if (!isSmooth) {
            return white(i & mask(), j & mask(), key);
        }
        Pcg3d bits = Pcg3d.of(i, j, key);
        return du * (2 * Pcg3d.unit(bits.x()) - 1) + dv * (2 * Pcg3d.unit(bits.y()) - 1);
    }

    /** Returns the source's white noise: Elias's hash. */
    static double white(int x, int y, int t) {
        int n = x + 57 * y + 131 * t;
        n = n << 13 ^ n;
        return 1 - (n * (n * n * 15731 + 789221) + 1376312589 & 0x7fffffff) * 0x1p-30;
    }
}
