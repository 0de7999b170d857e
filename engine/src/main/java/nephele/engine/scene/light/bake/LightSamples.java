package nephele.engine.scene.light.bake;

/**
 * Baked light at points of surfaces, and whence it comes: enough for a normal that a normal map tilts.
 *
 * @param radiance of a white Lambertian surface there: irradiance / π of the geometric normal, RGB of each point
 * @param moments of the luminance of the arriving radiance, over the whole sphere with black below the surface: the mean
 *     of direction × luminance, x y z in world axes, then the mean of luminance, of each point
 */
public record LightSamples(float[] radiance, float[] moments) {
    /** Components of {@link #radiance} for each point. */
    public static final int CHANNELS = 3;

    /** Components of {@link #moments} for each point. */
    public static final int MOMENTS = 4;

    /** Returns black samples. */
    public static LightSamples black(int points) {
        return new LightSamples(new float[CHANNELS * points], new float[MOMENTS * points]);
    }

    public int points() {
        return radiance.length / CHANNELS;
    }

    /** Adds the samples of other light at the same points, times a gain. */
    void add(LightSamples other, float gain) {
        for (int i = 0; i < radiance.length; i++) {
            radiance[i] += gain * other.radiance[i];
        }
        for (int i = 0; i < moments.length; i++) {
            moments[i] += gain * other.moments[i];
        }
    }
}
