package nephele.engine.reference.volume;

import java.util.SplittableRandom;
import nephele.engine.cloud.PhaseFunction;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/**
 * Estimates the radiance that a ray receives through media, by random walks from the eye with next-event estimation
 * towards the sun. Unbiased: paths have no greatest length, weak ones end by Russian roulette. Immutable.
 */
public final class VolumeTracer {
    /** Weight below which roulette begins, and the one with which a survivor goes on. */
    private static final double ROULETTE_BELOW = 0.25;

    private static final double SURVIVOR = 0.5;

    private final CloudMedia media;
    private final OutsideLight light;

    public VolumeTracer(CloudMedia media, OutsideLight light) {
        this.media = media;
        this.light = light;
    }

    /**
     * Returns a random RGB radiance whose mean is what the ray receives.
     *
     * @param ray of unit direction
     */
    public Vec3 radiance(Ray ray, SplittableRandom random) {
        CloudMedia.Collision met = media.collision(ray, 0, Double.POSITIVE_INFINITY, random);
        return met == null ? light.skyRadiance() : radianceAt(met, ray, random);
    }

    /**
     * Returns a random RGB radiance whose mean is what the ray receives if its first collision is {@code first}.
     *
     * @param ray of unit direction
     */
    public Vec3 radianceAt(CloudMedia.Collision first, Ray ray, SplittableRandom random) {
        var part = Ray.reusable();
        CloudMedia.Collision met = first;
        Vec3 at = ray.at(met.metres());
        var direction = new Vec3(ray.directionX(), ray.directionY(), ray.directionZ());
        double weight = 1;
        double sun = 0;
        while (true) {
            weight = surviving(weight * met.medium().albedo(), random);
            if (weight == 0) {
                return light.irradiance().scaled(sun);
            }
            PhaseFunction phase = met.medium().phase();
            sun += weight * sunlight(at, direction, phase, part, random);
            direction = Deflection.of(direction, phase.sampleSeparation(random), random);
            aim(part, at, direction);
            met = media.collision(part, 0, Double.POSITIVE_INFINITY, random);
            if (met == null) {
                return light.irradiance().scaled(sun).addScaled(weight, light.skyRadiance());
            }
            at = part.at(met.metres());
        }
    }

    /** Returns 0 for a path that ends. */
    private static double surviving(double weight, SplittableRandom random) {
        if (weight >= ROULETTE_BELOW) {
            return weight;
        }
        return random.nextDouble() * SURVIVOR < weight ? SURVIVOR : 0;
    }

    /** Returns the sunlight that one scattering turns towards the eye, divided by the sun's irradiance. */
    private double sunlight(Vec3 at, Vec3 direction, PhaseFunction phase, Ray part, SplittableRandom random) {
        if (!light.hasSun()) {
            return 0;
        }
        aim(part, at, light.directionTowardsSun());
        double scattered = phase.perSteradian(Deflection.separation(direction, light.directionTowardsSun()));
        return scattered * media.transmittance(part, 0, Double.POSITIVE_INFINITY, random);
    }

    private static void aim(Ray ray, Vec3 origin, Vec3 direction) {
        ray.aim(origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z());
    }
}
