package nephele.engine.cloud.light;

import java.util.stream.IntStream;
import nephele.engine.cloud.TwoStreamSlab;

/**
 * Sunlight that a cloud scatters by small angles, any number of times, and by one angle of any size. For a path of
 * optical depth τ that turns once by the angle θ in all, it is Σ ωⁿ e^−τ τⁿ⁻¹ / n! p_n(θ), p_n being the phase function
 * convolved n times with itself. On a straight path the sum over its points is the small-angle solution of the
 * transport equation (Goudsmit and Saunderson 1940): each of the n scatterings may be the one that is summed over,
 * hence 1/n! instead of 1/(n − 1)!. The term n = 1 is exact single scattering.
 *
 * <p>What the {@link TwoStreamSlab} counts as diffuse is left out, so that nothing counts twice: the moments of degree 0 and
 * 1 are those of the forward peak of delta-Eddington. Values can be negative.
 *
 * <p>The values are tabulated by separation and depth; a shader reads the same table with linear filtering.
 */
public final class SmallAngleScattering {
    public static final int SEPARATIONS = 64;
    public static final int DEPTHS = 64;

    private static final double MOST_DEPTH = 400;
    /** The forward peak is gone at this scaled depth. */
    private static final double SCALED_DEPTH = 25;

    private final double deepest;
    private final float[] values = new float[SEPARATIONS * DEPTHS];

    public SmallAngleScattering(CloudOptics optics) {
        deepest = Math.min(MOST_DEPTH, SCALED_DEPTH / optics.scaled().depthFactor());
        int orders = (int) (deepest + 10 * Math.sqrt(deepest) + 20);
        IntStream.range(0, SEPARATIONS).parallel().forEach(column -> {
            double[] terms = terms(optics, separation(column), orders);
            for (int row = 0; row < DEPTHS; row++) {
                values[row * SEPARATIONS + column] = (float) sum(terms, depth(row));
            }
        });
    }

    private static double separation(int column) {
        double u = column / (SEPARATIONS - 1.0);
        return 4 * u * u * u * u;
    }

    private double depth(int row) {
        double v = row / (DEPTHS - 1.0);
        return deepest * v * v;
    }

    /** Returns ωⁿ times the phase function of each order without its diffuse part; index 0 is order 1. */
    private static double[] terms(CloudOptics optics, double separation, int orders) {
        double cosine = 1 - separation / 2;
        double[] terms = new double[orders];
        for (int n = 1; n <= orders; n++) {
            double forward = Math.pow(optics.forwardFraction(), n);
            double mean = Math.pow(optics.meanCosine(), n);
            double diffuse = (1 - forward + 3 * (mean - forward) * cosine) / (4 * Math.PI);
            terms[n - 1] = Math.pow(optics.albedo(), n) * (optics.afterScatterings(n, separation) - diffuse);
        }
        return terms;
    }

    /** Sums with the weights e^−τ τⁿ⁻¹ / n!, which grow to n ≈ τ. */
    private static double sum(double[] terms, double depth) {
        double weight = Math.exp(-depth);
        double sum = 0;
        for (int n = 1; n <= terms.length; n++) {
            sum += weight * terms[n - 1];
            weight *= depth / (n + 1);
        }
        return sum;
    }

    /** Returns the optical depth beyond which the table has no light. */
    public double deepest() {
        return deepest;
    }

    /** Returns the table, depth by depth. */
    public float[] values() {
        return values.clone();
    }

    /**
     * Returns the light that one optical depth scatters, per unit irradiance and steradian.
     *
     * @param separation |d − l|² of the directions before and after
     * @param depth of the whole path, from outside to the point and from there to the eye
     */
    public double at(double separation, double depth) {
        double x = columnOf(separation);
        double y = rowOf(depth);
        int row = Math.min(DEPTHS - 2, (int) y);
        return between(x, Math.min(SEPARATIONS - 2, (int) x), y - row, row);
    }

    private static double columnOf(double separation) {
        return Math.sqrt(Math.sqrt(separation / 4)) * (SEPARATIONS - 1);
    }

    private double rowOf(double depth) {
        return Math.sqrt(Math.min(1, depth / deepest)) * (DEPTHS - 1);
    }

    private double between(double x, int column, double v, int row) {
        double u = x - column;
        int at = row * SEPARATIONS + column;
        double near = values[at] + u * (values[at + 1] - values[at]);
        double far = values[at + SEPARATIONS] + u * (values[at + SEPARATIONS + 1] - values[at + SEPARATIONS]);
        return near + v * (far - near);
    }

    /** Returns an object for so many depths, which are then set. */
    Steps steps(int count) {
        return new Steps(count);
    }

    /**
     * Weighted optical depths whose light is summed for many separations: their places in the table are found once.
     * Not for several threads.
     */
    final class Steps {
        private final int[] rows;
        private final double[] fractions;
        private final double[] weights;

        private Steps(int count) {
            rows = new int[count];
            fractions = new double[count];
            weights = new double[count];
        }

        /** Sets the depth of a whole path, as in {@link #at}, and the factor on its light. */
        void set(int step, double depth, double weight) {
            double y = rowOf(depth);
            rows[step] = Math.min(DEPTHS - 2, (int) y);
            fractions[step] = y - rows[step];
            weights[step] = weight;
        }

        /** Returns a sum to which the light of all steps is added one by one. */
        double addedTo(double sum, double separation) {
            double x = columnOf(separation);
            int column = Math.min(SEPARATIONS - 2, (int) x);
            double all = sum;
            for (int step = 0; step < rows.length; step++) {
                all += weights[step] * between(x, column, fractions[step], rows[step]);
            }
            return all;
        }
    }
}
