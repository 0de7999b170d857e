package nephele.engine.reference.volume;

import java.util.SplittableRandom;
import nephele.engine.cloud.PhaseFunction;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/**
 * Estimates the radiance that a ray receives through media, by random walks from the eye with next-event estimation
 * towards sun and moon. Walls are black. Unbiased: paths have no greatest length, weak ones end by Russian roulette. As many
 * threads may use it as may use its {@link Surroundings}.
 */
public final class VolumeTracer {
    /** Weight below which roulette begins, and the one with which a survivor goes on. */
    private static final double ROULETTE_BELOW = 0.25;

    private static final double SURVIVOR = 0.5;

    private static final double INFINITE = Double.POSITIVE_INFINITY;

    private final CloudMedia media;
    private final Surroundings around;

    public VolumeTracer(CloudMedia media, Surroundings around) {
        this.media = media;
        this.around = around;
    }

    /**
     * Returns a random RGB radiance whose mean is what the ray receives.
     *
     * @param ray of unit direction
     */
    public Vec3 radiance(Ray ray, SplittableRandom random) {
        CloudMedia.Collision met = media.collision(ray, 0, around.reachMetres(ray), random);
        if (around.isPathBlocked(ray, met == null ? INFINITE : met.metres())) {
            return Vec3.ZERO;
        }
        return met == null ? around.skylight(ray.at(0), direction(ray)) : radianceAt(met, ray, random);
    }

    /**
     * Returns a random RGB radiance whose mean is what the ray receives if its first collision is {@code first} and no
     * wall is before it.
     *
     * @param ray of unit direction
     */
    public Vec3 radianceAt(CloudMedia.Collision first, Ray ray, SplittableRandom random) {
        return new Walk(ray, random).from(first);
    }

    private static Vec3 direction(Ray ray) {
        return new Vec3(ray.directionX(), ray.directionY(), ray.directionZ());
    }

    /** One path against the light, from its first collision to its end. */
    private final class Walk {
        private final SplittableRandom random;
        private final Ray ray;
        private final Ray towardsLight = Ray.reusable();
        private Vec3 direction;
        private double weight = 1;
        private Vec3 sum = Vec3.ZERO;

        Walk(Ray first, SplittableRandom random) {
            this.random = random;
            direction = direction(first);
            ray = Ray.of(first.at(0), direction);
        }

        Vec3 from(CloudMedia.Collision first) {
            CloudMedia.Collision met = first;
            while (true) {
                Vec3 at = ray.at(met.metres());
                if (!survives(met.medium().albedo())) {
                    return sum;
                }
                PhaseFunction phase = met.medium().phase();
                for (DistantLight light : around.lights()) {
                    add(light, at, phase);
                }
                direction = Deflection.of(direction, phase.sampleSeparation(random), random);
                aim(ray, at, direction);
                met = media.collision(ray, 0, around.reachMetres(ray), random);
                if (around.isPathBlocked(ray, met == null ? INFINITE : met.metres())) {
                    return sum;
                }
                if (met == null) {
                    return sum.addScaled(weight, around.skylight(at, direction));
                }
            }
        }

        /** Weakens the path by an albedo; returns false if it ends. */
        private boolean survives(double albedo) {
            weight *= albedo;
            if (weight < ROULETTE_BELOW) {
                weight = random.nextDouble() * SURVIVOR < weight ? SURVIVOR : 0;
            }
            return weight > 0;
        }

        /** Adds the light of sun or moon that a scattering turns towards the eye. */
        private void add(DistantLight light, Vec3 at, PhaseFunction phase) {
            Vec3 irradiance = light.irradiance(at);
            if (irradiance.x() + irradiance.y() + irradiance.z() == 0) {
                return;
            }
            aim(towardsLight, at, light.towards());
            if (!around.isLightBlocked(towardsLight)) {
                double scattered = phase.perSteradian(Deflection.separation(direction, light.towards()));
                double fraction = media.transmittance(towardsLight, 0, around.reachMetres(towardsLight), random);
                sum = sum.addScaled(weight * scattered * fraction, irradiance);
            }
        }

        private static void aim(Ray ray, Vec3 origin, Vec3 direction) {
            ray.aim(origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z());
        }
    }
}
