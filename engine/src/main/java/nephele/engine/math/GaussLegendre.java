package nephele.engine.math;

/**
 * Gauss–Legendre quadrature on [0, 1], with the integrals from 0 to each node of the polynomial through the values at the
 * nodes.
 */
public final class GaussLegendre {
    public final double[] nodes;
    public final double[] weights;
    /** Row j has the weights of the values for the integral from 0 to node j. */
    public final double[][] upTo;

    public GaussLegendre(int count) {
        nodes = new double[count];
        weights = new double[count];
        for (int i = 0; i < count; i++) {
            double x = root(count, i);
            double slope = slope(count, x);
            nodes[count - 1 - i] = (1 + x) / 2;
            weights[count - 1 - i] = 1 / ((1 - x * x) * slope * slope);
        }
        upTo = integrals();
    }

    /** Newton's iteration from Chebyshev's estimate of the i-th root, the largest first. */
    private static double root(int degree, int i) {
        double x = StrictMath.cos(Math.PI * (i + 0.75) / (degree + 0.5));
        for (int step = 0; step < 50; step++) {
            double change = value(degree, x) / slope(degree, x);
            x -= change;
            if (Math.abs(change) < 1e-16) {
                break;
            }
        }
        return x;
    }

    private static double value(int degree, double x) {
        double before = 1;
        double now = x;
        for (int l = 2; l <= degree; l++) {
            double next = ((2 * l - 1) * x * now - (l - 1) * before) / l;
            before = now;
            now = next;
        }
        return degree == 0 ? 1 : now;
    }

    private static double slope(int degree, double x) {
        return degree * (x * value(degree, x) - value(degree - 1, x)) / (x * x - 1);
    }

    /**
     * The polynomial through the values has the Legendre coefficients (2l + 1) Σ weight × value × P_l, exact for the
     * degrees below the number of nodes; its integral follows from (2l + 1) P_l = (P_{l+1} − P_{l−1})'.
     */
    private double[][] integrals() {
        int count = nodes.length;
        double[][] values = new double[count][];
        for (int k = 0; k < count; k++) {
            values[k] = values(count, 2 * nodes[k] - 1);
        }
        double[][] matrix = new double[count][count];
        for (int j = 0; j < count; j++) {
            for (int k = 0; k < count; k++) {
                double sum = values[j][1] / 2 + 0.5;
                for (int l = 1; l < count; l++) {
                    sum += values[k][l] * (values[j][l + 1] - values[j][l - 1]) / 2;
                }
                matrix[j][k] = weights[k] * sum;
            }
        }
        return matrix;
    }

    /** Returns the Legendre polynomials of degree 0 to {@code degree}, at least 1, at a place. */
    private static double[] values(int degree, double x) {
        double[] values = new double[degree + 1];
        values[0] = 1;
        values[1] = x;
        for (int l = 2; l <= degree; l++) {
            values[l] = ((2 * l - 1) * x * values[l - 1] - (l - 1) * values[l - 2]) / l;
        }
        return values;
    }
}
