package nephele.workshop.prove.cloud;

import java.util.SplittableRandom;
import nephele.engine.cloud.field.CloudMedium;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.measure.RandomMean;
import nephele.engine.reference.volume.Deflection;
import nephele.engine.reference.volume.MajorantTracking;

/**
 * Walks of photons that fall on a plane-parallel slab from above. A photon has a weight, reduced by the albedo at each
 * collision; weak ones end by Russian roulette, no path is cut off. A weight never exceeds 1, so the variance of a mean
 * m is at most m (1 − m) by the number of paths.
 */
final class SlabWalk {
    /** The incident angle that stands for isotropic radiance. */
    static final double DIFFUSE = Double.NaN;

    private static final double ROULETTE_BELOW = 0.1;
    private static final double SURVIVOR = 0.2;

    private final CloudMedium medium;
    private final SplittableRandom random;
    private final Ray ray = Ray.reusable();
    private final RandomMean reflected;
    private final RandomMean transmitted;

    /**
     * Follows photons.
     *
     * @param mu0 cosine of the incident angle, or {@link #DIFFUSE}
     */
    SlabWalk(CloudMedium medium, long seed, double mu0, long paths) {
        this.medium = medium;
        random = new SplittableRandom(seed);
        double up = 0;
        double upSquared = 0;
        double down = 0;
        double downSquared = 0;
        for (long path = 0; path < paths; path++) {
            double left = leaving(Double.isNaN(mu0) ? Math.sqrt(1 - random.nextDouble()) : mu0);
            if (left > 0) {
                up += left;
                upSquared += left * left;
            } else {
                down -= left;
                downSquared += left * left;
            }
        }
        reflected = new RandomMean(up / paths, error(up, upSquared, paths));
        transmitted = new RandomMean(down / paths, error(down, downSquared, paths));
    }

    /** Returns the fraction of the incident flux that leaves above. */
    RandomMean reflected() {
        return reflected;
    }

    /** Returns the fraction of the incident flux that leaves below. */
    RandomMean transmitted() {
        return transmitted;
    }

    private static double error(double sum, double squared, long paths) {
        double mean = sum / paths;
        return Math.sqrt(Math.max(0, squared / paths - mean * mean) / paths);
    }

    /** Returns the weight that leaves, negative if it leaves below. */
    private double leaving(double mu0) {
        var direction = new Vec3(Math.sqrt(1 - mu0 * mu0), -mu0, 0);
        var at = new Vec3(0, medium.field().bounds().maxY(), 0);
        double weight = 1;
        while (true) {
            ray.aim(at.x(), at.y(), at.z(), direction.x(), direction.y(), direction.z());
            double metres = MajorantTracking.collision(medium.field(), ray, 0, Double.POSITIVE_INFINITY, random);
            if (metres == Double.POSITIVE_INFINITY) {
                return direction.y() > 0 ? weight : -weight;
            }
            weight *= medium.albedo();
            if (weight < ROULETTE_BELOW) {
                if (random.nextDouble() * SURVIVOR >= weight) {
                    return 0;
                }
                weight = SURVIVOR;
            }
            at = ray.at(metres);
            direction = Deflection.of(direction, medium.phase().sampleSeparation(random), random);
        }
    }
}
