package nephele.engine.reference;

import nephele.engine.level.appearance.Reflectance;

/**
 * The albedo of the GGX lobe that scatters once, without Fresnel's factor, by roughness and cosine: tabulated from
 * integrals over visible normals, linear between nodes. Immutable.
 */
final class GgxAlbedo {
    private static final int NODES = 64;
    private static final int SAMPLES = 64;
    private static final double LEAST_COSINE = 1e-3;
    private static final double[] BOOLE = {7, 32, 12, 32, 7};

    static final GgxAlbedo ALL = new GgxAlbedo();

    /** The albedo at each node, by roughness, then by the root of the cosine; {@code grazing} likewise. */
    private final double[] all = new double[NODES * NODES];

    private final double[] grazing = new double[NODES * NODES];
    private final double[] allOnMean = new double[NODES];
    private final double[] grazingOnMean = new double[NODES];

    private GgxAlbedo() {
        for (int row = 0; row < NODES; row++) {
            double roughness = Math.max(row, 0.5) / (NODES - 1);
            for (int column = 0; column < NODES; column++) {
                double root = (double) column / (NODES - 1);
                integrate(roughness, Math.max(LEAST_COSINE, root * root), row * NODES + column);
            }
            allOnMean[row] = onMean(all, row);
            grazingOnMean[row] = onMean(grazing, row);
        }
    }

    /** Puts the integrals at a node: means over visible normals of the masking of light, with and without (1 − v·h)⁵. */
    private void integrate(double roughness, double cosine, int node) {
        double alpha = roughness * roughness;
        double alpha2 = alpha * alpha;
        double sine = Math.sqrt(1 - cosine * cosine);
        double length = Math.sqrt(alpha2 * sine * sine + cosine * cosine);
        double eyeX = alpha * sine / length;
        double eyeZ = cosine / length;
        for (int i = 0; i < SAMPLES; i++) {
            // Steep facets, which mask most, are a small end of the cap: it gets most of the steps.
            double step = (i + 0.5) / SAMPLES;
            double z = step * step * step * step * (1 + eyeZ) - eyeZ;
            double weight = 4 * step * step * step / (SAMPLES * SAMPLES);
            double radius = Math.sqrt(Math.max(0, 1 - z * z));
            for (int j = 0; j < SAMPLES; j++) {
                double angle = Math.PI * (j + 0.5) / SAMPLES;
                double x = alpha * (radius * StrictMath.cos(angle) + eyeX);
                double y = alpha * radius * StrictMath.sin(angle);
                double up = z + eyeZ;
                double size = Math.sqrt(x * x + y * y + up * up);
                double eyeOnFacet = (sine * x + cosine * up) / size;
                double light = 2 * eyeOnFacet * up / size - cosine;
                if (light > 0) {
                    double masked = weight * unmasked(alpha2, cosine, light);
                    double away = 1 - Math.min(1, eyeOnFacet);
                    all[node] += masked;
                    grazing[node] += masked * away * away * away * away * away;
                }
            }
        }
    }

    /** Returns Smith's G over the part of it that the eye masks. */
    private static double unmasked(double alpha2, double nDotV, double nDotL) {
        double eye = 2 * nDotV / (nDotV + Math.sqrt(alpha2 + (1 - alpha2) * nDotV * nDotV));
        return 4 * nDotL * nDotV * Reflectance.visibility(alpha2, nDotV, nDotL) / eye;
    }

    /**
     * Returns the mean of a row over the hemisphere, weighted by the cosine: of the linear interpolation between its nodes
     * exactly, by Boole's rule, so that what the means say is lost is what {@link #all} says.
     */
    private static double onMean(double[] table, int row) {
        double sum = 0;
        for (int column = 0; column < NODES - 1; column++) {
            for (int i = 0; i < BOOLE.length; i++) {
                double at = column + 0.25 * i;
                double root = at / (NODES - 1);
                sum += BOOLE[i] / 90 * 4 * root * root * root * between(table, row, at) / (NODES - 1);
            }
        }
        return sum;
    }

    private static double between(double[] table, int row, double column) {
        int left = Math.min(NODES - 2, (int) column);
        double weight = column - left;
        return table[row * NODES + left] * (1 - weight) + table[row * NODES + left + 1] * weight;
    }

    private static double read(double[] table, double roughness, double cosine) {
        double row = roughness * (NODES - 1);
        int low = Math.min(NODES - 2, (int) row);
        double column = Math.sqrt(cosine) * (NODES - 1);
        return between(table, low, column) * (low + 1 - row) + between(table, low + 1, column) * (row - low);
    }

    private static double read(double[] means, double roughness) {
        double row = roughness * (NODES - 1);
        int low = Math.min(NODES - 2, (int) row);
        return means[low] * (low + 1 - row) + means[low + 1] * (row - low);
    }

    /** Returns the lobe's albedo if every facet reflected all light. */
    double all(double roughness, double cosine) {
        return read(all, roughness, Math.min(1, cosine));
    }

    /** Returns the part of it that Schlick's factor adds: weighted by (1 − v·h)⁵. */
    double grazing(double roughness, double cosine) {
        return read(grazing, roughness, Math.min(1, cosine));
    }

    /** Returns the mean of {@link #all} over the hemisphere, weighted by the cosine. */
    double allOnMean(double roughness) {
        return read(allOnMean, roughness);
    }

    /** Returns the mean of {@link #grazing}, likewise. */
    double grazingOnMean(double roughness) {
        return read(grazingOnMean, roughness);
    }
}
