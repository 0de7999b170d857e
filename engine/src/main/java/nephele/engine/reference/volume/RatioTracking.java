package nephele.engine.reference.volume;

import java.util.SplittableRandom;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.MajorantWalk;
import nephele.engine.math.Ray;

/**
 * Estimates transmittance without bias: the product of the null probabilities of the collisions with the majorant
 * (Novák et al. 2014, "Residual Ratio Tracking for Estimating Attenuation in Participating Media"). Small products end
 * by Russian roulette.
 */
public final class RatioTracking {
    /** Transmittance below which roulette begins, and the one with which a survivor goes on. */
    private static final double ROULETTE_BELOW = 0.1;

    private static final double SURVIVOR = 0.25;

    private RatioTracking() {}

    /**
     * Returns a random number in 0 to 1 whose mean is the transmittance of a part of a ray.
     *
     * @param ray of unit direction
     */
    public static double transmittance(
            ExtinctionField field, Ray ray, double fromMetres, double toMetres, SplittableRandom random) {
        MajorantWalk walk = field.walk(ray, fromMetres, toMetres);
        double transmittance = 1;
        double depthLeft = DeltaTracking.randomDepth(random);
        while (walk.next()) {
            double majorant = walk.perMetre();
            double at = walk.fromMetres();
            double depth = (walk.toMetres() - at) * majorant;
            while (depthLeft < depth) {
                at += depthLeft / majorant;
                transmittance *= Math.max(0, 1 - DeltaTracking.perMetre(field, ray, at) / majorant);
                if (transmittance < ROULETTE_BELOW) {
                    if (random.nextDouble() * SURVIVOR >= transmittance) {
                        return 0;
                    }
                    transmittance = SURVIVOR;
                }
                depth -= depthLeft;
                depthLeft = DeltaTracking.randomDepth(random);
            }
            depthLeft -= depth;
        }
        return transmittance;
    }
}
