package nephele.engine.bake;

import org.joml.Vector3dc;

/**
 * Light that one receiver gathers, for each layer: the radiance that a white Lambertian surface would reflect, RGB, then
 * the moments of the arriving luminance as in {@link nephele.engine.scene.light.bake.LightSamples}.
 */
final class Gathered {
    /** Values of a layer. */
    static final int VALUES = 7;

    /** Rays nearer to the horizon count as if at this cosine; their directions matter little, their weight would not. */
    private static final double LEAST_COSINE = 0.05;

    private final double[] sums;

    Gathered(int layers) {
        sums = new double[VALUES * layers];
    }

    /**
     * Adds irradiance / π from a direction.
     *
     * @param cosine between direction and normal
     */
    void add(int layer, Vector3dc direction, double cosine, double red, double green, double blue) {
        int at = VALUES * layer;
        sums[at] += red;
        sums[at + 1] += green;
        sums[at + 2] += blue;
        // Irradiance / π of a solid angle is radiance × cosine / π; its share of the sphere's mean is radiance / 4π.
        double mean = luminance(red, green, blue) / (4 * Math.max(cosine, LEAST_COSINE));
        sums[at + 3] += mean * direction.x();
        sums[at + 4] += mean * direction.y();
        sums[at + 5] += mean * direction.z();
        sums[at + 6] += mean;
    }

    void add(int layer, Vector3dc direction, double cosine, Vector3dc radiance, double factor) {
        add(layer, direction, cosine, factor * radiance.x(), factor * radiance.y(), factor * radiance.z());
    }

    void add(Gathered other) {
        for (int i = 0; i < sums.length; i++) {
            sums[i] += other.sums[i];
        }
    }

    /** Returns the luminance of the radiance of all layers (ITU-R BT.709). */
    double luminance() {
        double sum = 0;
        for (int at = 0; at < sums.length; at += VALUES) {
            sum += luminance(sums[at], sums[at + 1], sums[at + 2]);
        }
        return sum;
    }

    static double luminance(double red, double green, double blue) {
        return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
    }

    /** Writes the values times a factor. */
    void write(double factor, float[] to, int at) {
        for (int i = 0; i < sums.length; i++) {
            to[at + i] = (float) (factor * sums[i]);
        }
    }
}
