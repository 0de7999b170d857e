package nephele.engine.scene.light;

import nephele.engine.level.appearance.SkyRadiance;
import org.joml.Vector3d;

/**
 * The sky's irradiance by surface normal, as nine coefficients (Ramamoorthi and Hanrahan 2001, "An Efficient
 * Representation for Irradiance Environment Maps", equations 8 to 11); the twin of {@code sky-ambient.glsl}. It is
 * divided by π: a white Lambert surface has this radiance, and a constant sky results in its own radiance.
 *
 * @param coefficients RGB for each of 1, y, z, x, xy, yz, 3z² − 1, xz, x² − y², including all constants
 */
public record SkyIrradiance(double[] coefficients) {
    public static final int TERMS = 9;

    /** Cells along a side of the cube over which the sky is integrated. */
    private static final int CELLS = 96;

    private static final double[] BASIS = {
        0.282095, 0.488603, 0.488603, 0.488603, 1.092548, 1.092548, 0.315392, 1.092548, 0.546274
    };

    /** The factors of a cosine lobe on the bands 0, 1 and 2, divided by π. */
    private static final double[] COSINE_LOBE = {1, 2.0 / 3, 1.0 / 4};

    public static SkyIrradiance black() {
        return new SkyIrradiance(new double[3 * TERMS]);
    }

    public static SkyIrradiance of(SkyRadiance sky) {
        return of(sky, CELLS);
    }

    /** @param side cells along a side of the cube over which the sky is integrated */
    public static SkyIrradiance of(SkyRadiance sky, int side) {
        double[] sums = new double[3 * TERMS];
        double total = 0;
        for (int cell = 0; cell < 6 * side * side; cell++) {
            double s = 2 * (cell % side + 0.5) / side - 1;
            double t = 2 * (cell / side % side + 0.5) / side - 1;
            double length2 = 1 + s * s + t * t;
            double solidAngle = 1 / (length2 * Math.sqrt(length2));
            total += solidAngle;
            accumulate(sums, sky, cubeDirection(cell / (side * side), s, t), solidAngle);
        }
        for (int i = 0; i < sums.length; i++) {
            sums[i] *= 4 * Math.PI / total;
        }
        return new SkyIrradiance(sums);
    }

    private static Vector3d cubeDirection(int face, double s, double t) {
        double w = (face & 1) == 0 ? 1 : -1;
        Vector3d direction =
                switch (face / 2) {
                    case 0 -> new Vector3d(w, s, t);
                    case 1 -> new Vector3d(s, w, t);
                    default -> new Vector3d(s, t, w);
                };
        return direction.normalize();
    }

    private static void accumulate(double[] sums, SkyRadiance sky, Vector3d d, double weight) {
        Vector3d radiance = sky.from(d.x, d.y, d.z);
        double[] shape = shape(d.x, d.y, d.z);
        for (int i = 0; i < TERMS; i++) {
            double folded = weight * BASIS[i] * BASIS[i] * COSINE_LOBE[i == 0 ? 0 : i < 4 ? 1 : 2] * shape[i];
            sums[3 * i] += folded * radiance.x;
            sums[3 * i + 1] += folded * radiance.y;
            sums[3 * i + 2] += folded * radiance.z;
        }
    }

    private static double[] shape(double x, double y, double z) {
        return new double[] {1, y, z, x, x * y, y * z, 3 * z * z - 1, x * z, x * x - y * y};
    }

    /** Returns irradiance / π at a unit normal, never negative. */
    public Vector3d ambient(double x, double y, double z) {
        double[] shape = shape(x, y, z);
        Vector3d sum = new Vector3d();
        for (int i = 0; i < TERMS; i++) {
            sum.add(
                    coefficients[3 * i] * shape[i],
                    coefficients[3 * i + 1] * shape[i],
                    coefficients[3 * i + 2] * shape[i]);
        }
        return sum.max(new Vector3d());
    }

    /** Returns the radiance up to the second band, never negative: all of it that irradiance depends on. */
    public Vector3d radiance(double x, double y, double z) {
        double[] shape = shape(x, y, z);
        Vector3d sum = new Vector3d();
        for (int i = 0; i < TERMS; i++) {
            double unfolded = shape[i] / COSINE_LOBE[i == 0 ? 0 : i < 4 ? 1 : 2];
            sum.add(
                    coefficients[3 * i] * unfolded,
                    coefficients[3 * i + 1] * unfolded,
                    coefficients[3 * i + 2] * unfolded);
        }
        return sum.max(new Vector3d());
    }
}
