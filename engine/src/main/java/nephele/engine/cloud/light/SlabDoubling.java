package nephele.engine.cloud.light;

import nephele.engine.math.GaussLegendre;

/**
 * The fluxes that leave slabs whose thickness doubles, by adding a slab to itself (G. N. Plass, G. W. Kattawar and F. E.
 * Catchings, "Matrix Operator Theory of Radiative Transfer", 1973), with {@value #NODES} directions on each side and a
 * forward peak that counts as unscattered (W. J. Wiscombe, "The Delta-M Method", 1977). Not for several threads.
 *
 * <p>The plane albedo for a beam is, by reciprocity, the radiance that the slab reflects in the beam's direction under even
 * light; so beams are directions of weight 0 whose rows are summed.
 */
final class SlabDoubling {
    private static final int NODES = 12;

    private final int size;
    private double[][] reflected;
    private double[][] passed;

    /**
     * @param thickness optical depth of the first slab, so small that light is scattered once in it
     * @param cosines of beams with the normal, above 0
     */
    SlabDoubling(CloudOptics optics, double thickness, double[] cosines) {
        var rule = new GaussLegendre(NODES);
        size = NODES + cosines.length;
        double[] cosine = new double[size];
        double[] weight = new double[size];
        System.arraycopy(rule.nodes, 0, cosine, 0, NODES);
        System.arraycopy(rule.weights, 0, weight, 0, NODES);
        System.arraycopy(cosines, 0, cosine, NODES, cosines.length);
        double forward = optics.moment(2 * NODES);
        double depth = thickness * (1 - optics.albedo() * forward);
        double scattered = optics.albedo() * (1 - forward) / (1 - optics.albedo() * forward);
        reflected = new double[size][size];
        passed = new double[size][size];
        double[][] legendre = new double[size][];
        for (int i = 0; i < size; i++) {
            legendre[i] = legendre(cosine[i]);
        }
        for (int i = 0; i < size; i++) {
            double perDepth = -Math.expm1(-depth / cosine[i]) / 2 * scattered;
            for (int j = 0; j < size; j++) {
                reflected[i][j] = perDepth * weight[j] * phase(optics, forward, legendre[i], legendre[j], -1);
                passed[i][j] = perDepth * weight[j] * phase(optics, forward, legendre[i], legendre[j], 1);
            }
            passed[i][i] += Math.exp(-depth / cosine[i]);
        }
    }

    private static double[] legendre(double x) {
        double[] values = new double[2 * NODES];
        values[0] = 1;
        values[1] = x;
        for (int l = 2; l < values.length; l++) {
            values[l] = ((2 * l - 1) * x * values[l - 1] - (l - 1) * values[l - 2]) / l;
        }
        return values;
    }

    /** Returns the phase function without its peak, averaged over azimuths; its mean over all cosines is 1. */
    private static double phase(CloudOptics optics, double forward, double[] from, double[] to, int side) {
        double sum = 0;
        double sign = 1;
        for (int l = 0; l < from.length; l++) {
            double moment = forward == 1 ? 0 : (optics.moment(l) - forward) / (1 - forward);
            sum += sign * (2 * l + 1) * moment * from[l] * to[l];
            sign *= side;
        }
        return sum;
    }

    /** Makes the slab twice as thick. */
    void addToItself() {
        double[][] between = product(reflected, reflected);
        for (int i = 0; i < size; i++) {
            for (int j = 0; j < size; j++) {
                between[i][j] = (i == j ? 1 : 0) - between[i][j];
            }
        }
        double[][] entering = solved(between, passed);
        double[][] back = product(passed, solved(between, product(reflected, passed)));
        double[][] through = product(passed, entering);
        for (int i = 0; i < size; i++) {
            for (int j = 0; j < size; j++) {
                back[i][j] += reflected[i][j];
            }
        }
        reflected = back;
        passed = through;
    }

    /** Returns the fraction of a beam's light that leaves the lit side. */
    double reflectance(int beam) {
        return sum(reflected[NODES + beam]);
    }

    /** Returns the fraction of a beam's light that leaves the other side, unscattered light included. */
    double transmittance(int beam) {
        return sum(passed[NODES + beam]);
    }

    private static double sum(double[] row) {
        double sum = 0;
        for (double value : row) {
            sum += value;
        }
        return sum;
    }

    private static double[][] product(double[][] a, double[][] b) {
        int size = a.length;
        double[][] product = new double[size][size];
        for (int i = 0; i < size; i++) {
            for (int k = 0; k < size; k++) {
                double left = a[i][k];
                for (int j = 0; j < size; j++) {
                    product[i][j] += left * b[k][j];
                }
            }
        }
        return product;
    }

    /** Returns a⁻¹ b by elimination. The pivots stay far from 0, since a is the identity less a contraction. */
    private static double[][] solved(double[][] a, double[][] b) {
        int size = a.length;
        double[][] left = new double[size][];
        double[][] right = new double[size][];
        for (int i = 0; i < size; i++) {
            left[i] = a[i].clone();
            right[i] = b[i].clone();
        }
        for (int pivot = 0; pivot < size; pivot++) {
            for (int row = 0; row < size; row++) {
                double factor = row == pivot ? 0 : left[row][pivot] / left[pivot][pivot];
                if (factor != 0) {
                    for (int j = 0; j < size; j++) {
                        left[row][j] -= factor * left[pivot][j];
                        right[row][j] -= factor * right[pivot][j];
                    }
                }
            }
        }
        for (int i = 0; i < size; i++) {
            for (int j = 0; j < size; j++) {
                right[i][j] /= left[i][i];
            }
        }
        return right;
    }
}
