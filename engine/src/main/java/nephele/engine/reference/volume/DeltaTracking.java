package nephele.engine.reference.volume;

import java.util.SplittableRandom;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.MajorantWalk;
import nephele.engine.math.Ray;

/**
 * Samples free flights without bias: collisions at the rate of the local majorant, of which a random part is null
 * (Woodcock et al. 1965; Novák et al. 2018, "Monte Carlo Methods for Volumetric Light Transport Simulation", section
 * 5.1).
 */
public final class DeltaTracking {
    private DeltaTracking() {}

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

    /** Returns an optical depth of exponential distribution with mean 1. */
    static double randomDepth(SplittableRandom random) {
        return -Math.log(1 - random.nextDouble());
    }

    static double perMetre(ExtinctionField field, Ray ray, double metres) {
        return field.perMetre(
                ray.originX() + metres * ray.directionX(),
                ray.originY() + metres * ray.directionY(),
                ray.originZ() + metres * ray.directionZ());
    }
}
