package nephele.engine.cloud;

import java.util.SplittableRandom;

/**
 * The phase function of Henyey and Greenstein 1941, "Diffuse radiation in the galaxy".
 *
 * @param g mean cosine of the scattering angle, −0.999 to 0.999
 */
public record HenyeyGreenstein(double g) implements PhaseFunction {
    private static final double GREATEST = 0.999;

    public HenyeyGreenstein {
        if (!(Math.abs(g) <= GREATEST)) {
            throw new IllegalArgumentException("asymmetry " + g + " is not in -0.999 to 0.999");
        }
    }

    /** Writes the denominator 1 + g² − 2g cos θ as (1 − g)² + g |d − l|², a sum without cancellation for g ≥ 0. */
    @Override
    public double perSteradian(double separation) {
        double squared = (1 - g) * (1 - g) + g * separation;
        return (1 - g) * (1 + g) / (4 * Math.PI * squared * Math.sqrt(squared));
    }

    /** Returns the fraction of light that is scattered into the cone around its direction whose edge has a separation. */
    public double fractionWithin(double separation) {
        double distance = Math.sqrt((1 - g) * (1 - g) + g * separation);
        // The difference 1/(1 − g) − 1/distance of the integral, written so that neither it nor a division by g loses
        // digits.
        return (1 + g) * separation / (2 * distance * (distance + 1 - g));
    }

    @Override
    public double sampleSeparation(SplittableRandom random) {
        return separationAt(random.nextDouble());
    }

    /**
     * Returns the separation that a random direction exceeds with probability {@code fraction}: the inverse of the usual
     * distribution of cos θ, transformed so that nothing is divided by g.
     */
    double separationAt(double fraction) {
        double root = 1 - g + 2 * g * fraction;
        return 4 * (1 - g) * (1 - g) * (1 - fraction) * (1 + g * fraction) / (root * root);
    }
}
