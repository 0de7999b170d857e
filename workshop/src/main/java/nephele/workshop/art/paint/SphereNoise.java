package nephele.workshop.art.paint;

import nephele.engine.math.SeededNoise;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Gradient noise in space, evaluated on the unit sphere, so that it has no seam and no distortion at the poles. */
public final class SphereNoise {
    private static final double OCTAVE_STEP = 2.03;

    private final int seed;
    private final SeededNoise hash;

    public SphereNoise(int seed) {
        this.seed = seed;
        hash = new SeededNoise(seed);
    }

    /** Returns gradient noise after Perlin (2002), about −1…1. */
    public double smooth(double x, double y, double z) {
        int i = (int) Math.floor(x);
        int j = (int) Math.floor(y);
        int k = (int) Math.floor(z);
        double a = x - i;
        double b = y - j;
        double c = z - k;
        double u = fade(a);
        double v = fade(b);
        double near = mix(
                mix(slope(i, j, k, a, b, c), slope(i + 1, j, k, a - 1, b, c), u),
                mix(slope(i, j + 1, k, a, b - 1, c), slope(i + 1, j + 1, k, a - 1, b - 1, c), u),
                v);
        double far = mix(
                mix(slope(i, j, k + 1, a, b, c - 1), slope(i + 1, j, k + 1, a - 1, b, c - 1), u),
                mix(slope(i, j + 1, k + 1, a, b - 1, c - 1), slope(i + 1, j + 1, k + 1, a - 1, b - 1, c - 1), u),
                v);
        return mix(near, far, fade(c));
    }

    /** Returns the sum of octaves, each about half the size and half the weight; about −1…1. */
    public double cloud(Vector3dc p, double frequency, int octaves) {
        double sum = 0;
        double weight = 0.6;
        double scale = frequency;
        for (int octave = 0; octave < octaves; octave++) {
            double shift = 17.3 * octave;
            sum += weight * smooth(p.x() * scale + shift, p.y() * scale - shift, p.z() * scale + 2 * shift);
            weight /= 2;
            scale *= OCTAVE_STEP;
        }
        return 1.3 * sum;
    }

    /** Returns ridged noise: 0 in the valleys to about 1 on sharp crests. */
    public double ridges(Vector3dc p, double frequency, int octaves) {
        double sum = 0;
        double weight = 0.55;
        double scale = frequency;
        for (int octave = 0; octave < octaves; octave++) {
            double crest = 1 - Math.abs(1.4 * smooth(p.x() * scale, p.y() * scale + 31 * octave, p.z() * scale));
            sum += weight * Math.max(0, crest) * crest;
            weight /= 2;
            scale *= OCTAVE_STEP;
        }
        return sum;
    }

    /** Returns the point displaced by noise, for flow patterns. */
    public Vector3d warped(Vector3dc p, double frequency, int octaves, double amount) {
        Vector3d away = new Vector3d(p).add(5.2, 1.3, 7.7);
        double x = new SphereNoise(seed + 1).cloud(away, frequency, octaves);
        double y = new SphereNoise(seed + 2).cloud(away, frequency, octaves);
        double z = new SphereNoise(seed + 3).cloud(away, frequency, octaves);
        return new Vector3d(p).add(amount * x, amount * y, amount * z);
    }

    /** Returns the dot product with a gradient towards one of the twelve edges of a cube. */
    private double slope(int i, int j, int k, double x, double y, double z) {
        int bits = hash.bits(i, j, k) >>> 20;
        double first = (bits & 1) == 0 ? 1 : -1;
        double second = (bits & 2) == 0 ? 1 : -1;
        return switch ((bits >>> 2) % 3) {
            case 0 -> first * x + second * y;
            case 1 -> first * y + second * z;
            default -> first * x + second * z;
        };
    }

    private static double fade(double t) {
        return t * t * t * (t * (t * 6 - 15) + 10);
    }

    private static double mix(double a, double b, double fraction) {
        return a + (b - a) * fraction;
    }
}
