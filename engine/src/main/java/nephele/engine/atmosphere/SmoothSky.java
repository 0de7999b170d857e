package nephele.engine.atmosphere;

import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * The light from all directions at the ground, the planet's own included, as the moments up to degree 2 of the light
 * field: all that a Lambertian surface needs (Ramamoorthi and Hanrahan 2001, section 2). Not for several threads.
 */
public final class SmoothSky {
    private static final int DEGREE = 2;

    private final DirectionMoments harmonics = new DirectionMoments(DEGREE);
    private final double[] values = new double[DirectionMoments.count(DEGREE)];
    private final double[][] moments = new double[Air.CHANNELS][values.length];
    private final Vec3 towardsSun;

    /** @param towardsSun unit */
    public SmoothSky(AirTables tables, Vec3 towardsSun) {
        this.towardsSun = towardsSun;
        double[] sums = new double[Air.CHANNELS];
        for (int k = 0; k < values.length; k++) {
            double[] weights = new double[Air.CHANNELS * values.length];
            for (int c = 0; c < Air.CHANNELS; c++) {
                weights[c * values.length + k] = 1;
            }
            tables.field().putSum(0, towardsSun.y(), weights, values.length, sums);
            for (int c = 0; c < Air.CHANNELS; c++) {
                moments[c][k] = sums[c];
            }
        }
    }

    /** Returns the smooth radiance from a unit direction, per unit solar irradiance, 1/sr. */
    public Vector3d radiance(double x, double y, double z) {
        double level = Math.hypot(x, z) * Math.hypot(towardsSun.x(), towardsSun.z());
        double azimuth = level > 1e-12 ? (x * towardsSun.x() + z * towardsSun.z()) / level : 1;
        harmonics.put(y, Math.max(-1, Math.min(1, azimuth)), values);
        double[] sum = new double[Air.CHANNELS];
        for (int c = 0; c < Air.CHANNELS; c++) {
            for (int k = 0; k < values.length; k++) {
                sum[c] += moments[c][k] * values[k];
            }
        }
        return new Vector3d(sum[0], sum[1], sum[2]);
    }
}
