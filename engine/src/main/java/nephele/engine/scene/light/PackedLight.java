package nephele.engine.scene.light;

import nephele.engine.math.Vec3;
import nephele.engine.scene.light.bake.LightSamples;

/**
 * Baked light as shaders read it: of each sample two words of three numbers with a common exponent (nine bits each, five
 * for the exponent: OpenGL's RGB9_E5). Twin of {@code baked-light.glsl}.
 *
 * @param radiance of a white surface, one word for each sample
 * @param direction ½ + ½ d with the mean direction d of the arriving light, |d| ≤ 1, one word for each sample
 */
public record PackedLight(int[] radiance, int[] direction) {
    private static final int MANTISSA_BITS = 9;
    private static final int MOST_MANTISSA = (1 << MANTISSA_BITS) - 1;
    /** The exponent of the unit of the mantissas if the stored one is 0: bias 15, and nine bits behind the point. */
    private static final int LEAST_EXPONENT = -24;

    private static final int MOST_EXPONENT = 31;
    private static final double LARGEST = MOST_MANTISSA * Math.scalb(1.0, MOST_EXPONENT + LEAST_EXPONENT);

    /**
     * The least relative irradiance of a surface's own normal that is divided by. Light from above the surface gives ½ or
     * more; interpolated normals of a model may leave that half space.
     */
    public static final double LEAST_OF_OWN_NORMAL = 0.25;

    public static PackedLight of(LightSamples samples) {
        int[] radiance = new int[samples.points()];
        int[] direction = new int[samples.points()];
        for (int i = 0; i < radiance.length; i++) {
            int at = LightSamples.CHANNELS * i;
            float[] rgb = samples.radiance();
            radiance[i] = packed(rgb[at], rgb[at + 1], rgb[at + 2]);
            Vec3 from = direction(samples, i);
            direction[i] = packed(0.5 + from.x() / 2, 0.5 + from.y() / 2, 0.5 + from.z() / 2);
        }
        return new PackedLight(radiance, direction);
    }

    /** Returns the mean direction of arriving light, shorter than 1 unless it is the only one; zero without light. */
    public static Vec3 direction(LightSamples samples, int point) {
        float[] moments = samples.moments();
        int at = LightSamples.MOMENTS * point;
        double luminance = moments[at + 3];
        return luminance > 0
                ? new Vec3(moments[at] / luminance, moments[at + 1] / luminance, moments[at + 2] / luminance)
                : Vec3.ZERO;
    }

    /** Returns a word; what is below 0 becomes 0, what is above 65408 that. */
    static int packed(double red, double green, double blue) {
        double r = Math.min(Math.max(red, 0), LARGEST);
        double g = Math.min(Math.max(green, 0), LARGEST);
        double b = Math.min(Math.max(blue, 0), LARGEST);
        double most = Math.max(r, Math.max(g, b));
        int exponent = Math.max(Math.getExponent(most) + 1 - MANTISSA_BITS, LEAST_EXPONENT);
        if (Math.rint(Math.scalb(most, -exponent)) > MOST_MANTISSA) {
            exponent++;
        }
        return mantissa(r, exponent)
                | mantissa(g, exponent) << MANTISSA_BITS
                | mantissa(b, exponent) << 2 * MANTISSA_BITS
                | exponent - LEAST_EXPONENT << 3 * MANTISSA_BITS;
    }

    private static int mantissa(double value, int exponent) {
        return (int) Math.rint(Math.scalb(value, -exponent));
    }

    /** Returns the three numbers of a word. */
    static Vec3 unpacked(int word) {
        double unit = Math.scalb(1.0, (word >>> 3 * MANTISSA_BITS) + LEAST_EXPONENT);
        return new Vec3(
                unit * (word & MOST_MANTISSA),
                unit * (word >>> MANTISSA_BITS & MOST_MANTISSA),
                unit * (word >>> 2 * MANTISSA_BITS & MOST_MANTISSA));
    }

    /**
     * Returns the irradiance on a plane of a normal, 1 for the mean over all normals: the non-linear reconstruction from a
     * mean radiance and a mean direction (Geomerics 2015, "Reconstructing Diffuse Lighting from Spherical Harmonic
     * Data"). Never negative.
     *
     * @param d the mean direction, |d| ≤ 1
     * @param n unit length
     */
    public static double relativeIrradiance(Vec3 d, Vec3 n) {
        double r = Math.min(d.length(), 1);
        double facing = r > 1e-4 ? d.dot(n) / r : 0;
        double p = 1 + 2 * r;
        double even = (1 - r) / (1 + r);
        return even + (1 - even) * (p + 1) * Math.pow(Math.max(0.5 + 0.5 * facing, 0), p);
    }
}
