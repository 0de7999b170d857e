package nephele.engine.cloud.field;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.light.CloudOptics;
import nephele.engine.level.Cloud;
import nephele.engine.math.Vec3;

/**
 * The share of its light that clouds leave the plain around a place, on the mean: what the ground throws back at them.
 * Columns are independent slabs after Eddington (Shettle and Weinman 1970), with τ (1 − ω g) for their depth.
 */
final class GroundShade {
    /** Columns along x and z. */
    private static final int ACROSS = 13;

    private static final double SPACING_METRES = 1500;
    private static final int ROWS = 16;
    private static final double LEAST_SINE = 0.05;

    private GroundShade() {}

    /** A cloud and its field at a time. */
    record Present(Cloud cloud, CloudMoment moment, ExtinctionField field) {
        /** Returns the vertical depth of a column, as isotropic scattering of the same effect. */
        double depth(double x, double z) {
            double base = moment.bounds().minY();
            double row = moment.heightMetres() / ROWS;
            double sum = 0;
            for (int j = 0; j < ROWS; j++) {
                sum += field.perMetre(x, base + (j + 0.5) * row, z) * row;
            }
            return sum * (1 - cloud.albedo() * CloudOptics.of(cloud).meanCosine());
        }
    }

    /**
     * Returns the share.
     *
     * @param sunSine of the sun's elevation
     * @param albedo of the ground
     */
    static double share(List<Present> clouds, Vec3 place, double sunSine, double albedo) {
        double mu = Math.max(LEAST_SINE, sunSine);
        double transmitted = 0;
        double diffuse = 0;
        int count = ACROSS * ACROSS;
        for (int n = 0; n < count; n++) {
            double x = place.x() + (n % ACROSS - ACROSS / 2) * SPACING_METRES;
            double z = place.z() + (n / ACROSS - ACROSS / 2) * SPACING_METRES;
            double depth =
                    clouds.stream().mapToDouble(cloud -> cloud.depth(x, z)).sum();
            double left = Math.exp(-depth / mu);
            transmitted += (2.0 / 3 + mu + (2.0 / 3 - mu) * left) / (4.0 / 3 + depth) / count;
            diffuse += 1 / (1 + 0.75 * depth) / count;
        }
        return transmitted / (1 - albedo * (1 - diffuse));
    }

    static List<Present> present(List<Cloud> clouds, List<ExtinctionField> fields, double seconds) {
        List<Present> all = new ArrayList<>();
        for (int i = 0; i < clouds.size(); i++) {
            all.add(new Present(clouds.get(i), CloudMoment.of(clouds.get(i), seconds), fields.get(i)));
        }
        return all;
    }
}
