package nephele.engine.reference.volume;

import java.util.SplittableRandom;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.MajorantWalk;
import nephele.engine.math.Ray;

/**
 * Free flights and transmittances through a medium without bias, by tentative collisions at the rate of the local majorant,
 * of which a random part is null (Woodcock et al. 1965; Novák et al. 2018, "Monte Carlo Methods for Volumetric Light
 * Transport Simulation", section 5.1).
 */
public final class MajorantTracking {
    /** Transmittance below which roulette begins, and the one with which a survivor goes on. */
    private static final double ROULETTE_BELOW = 0.1;

    private static final double SURVIVOR = 0.25;

    private MajorantTracking() {}

    /**
     * Returns the ray parameter in metres of the first collision, or infinity if there is none before {@code toMetres}.
     *
     * @param ray of unit direction
     */
    public static double collision(
            ExtinctionField field, Ray ray, double fromMetres, double toMetres, SplittableRandom random) {
        MajorantWalk walk = field.walk(ray, fromMetres, toMetres);
        double depthLeft = randomDepth(random);
        while (walk.next()) {
            double majorant = walk.perMetre();
            double at = walk.fromMetres();
            double depth = (walk.toMetres() - at) * majorant;
            while (depthLeft < depth) {
                at += depthLeft / majorant;
                if (random.nextDouble() * majorant < perMetre(field, ray, at)) {
                    return at;
                }
                depth -= depthLeft;
                depthLeft = randomDepth(random);
            }
            depthLeft -= depth;
        }
        return Double.POSITIVE_INFINITY;
    }

    /**
     * Returns a random number in 0 to 1 whose mean is the transmittance of a part of a ray: the
     * product of the null probabilities of the collisions (Novák et al. 2014, "Residual Ratio Tracking for Estimating
     * Attenuation in Participating Media"). Small products end by Russian roulette.
     *
     * @param ray of unit direction
     */
    public static double transmittance(
            ExtinctionField field, Ray ray, double fromMetres, double toMetres, SplittableRandom random) {
        MajorantWalk walk = field.walk(ray, fromMetres, toMetres);
        double transmittance = 1;
        double depthLeft = randomDepth(random);
        while (walk.next()) {
            double majorant = walk.perMetre();
            double at = walk.fromMetres();
            double depth = (walk.toMetres() - at) * majorant;
            while (depthLeft < depth) {
                at += depthLeft / majorant;
                transmittance *= Math.max(0, 1 - perMetre(field, ray, at) / majorant);
                if (transmittance < ROULETTE_BELOW) {
                    if (random.nextDouble() * SURVIVOR >= transmittance) {
                        return 0;
                    }
                    transmittance = SURVIVOR;
                }
                depth -= depthLeft;
                depthLeft = randomDepth(random);
            }
            depthLeft -= depth;
        }
        return transmittance;
    }

    /** Returns an optical depth of exponential distribution with mean 1. */
    private static double randomDepth(SplittableRandom random) {
        return -StrictMath.log(1 - random.nextDouble());
    }

    private static double perMetre(ExtinctionField field, Ray ray, double metres) {
        return field.perMetre(
                ray.originX() + metres * ray.directionX(),
                ray.originY() + metres * ray.directionY(),
                ray.originZ() + metres * ray.directionZ());
    }
}
