package nephele.workshop.prove.cloud;

import java.util.SplittableRandom;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.PhaseFunction;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.measure.RandomMean;
import nephele.engine.reference.volume.Deflection;
import nephele.engine.reference.volume.MajorantTracking;

/**
 * Light of a beam on a slab that is scattered once, to an eye above it or below.
 *
 * @param mu cosine of the scattered light, negative below the slab
 * @param mu0 cosine of the beam
 */
record SlabSingleScattering(ExtinctionField slab, PhaseFunction phase, double mu, double mu0)
        implements CloudLaw.Estimate {
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    /** Returns the radiance by the irradiance on a plane perpendicular to the beam, at albedo 1. */
    double expected(double depth) {
        double scattered = phase.perSteradian(Deflection.separation(eye(), sun()));
        if (mu > 0) {
            return scattered * mu0 / (mu + mu0) * -Math.expm1(-depth * (1 / mu + 1 / mu0));
        }
        double below = -mu;
        return below == mu0
                ? scattered * depth / mu0 * Math.exp(-depth / mu0)
                : scattered * mu0 / (below - mu0) * (Math.exp(-depth / below) - Math.exp(-depth / mu0));
    }

    /** Returns the direction from the eye, against the light. */
    private Vec3 eye() {
        return new Vec3(Math.sqrt(1 - mu * mu), -mu, 0);
    }

    private Vec3 sun() {
        return new Vec3(0, mu0, Math.sqrt(1 - mu0 * mu0));
    }

    @Override
    public RandomMean of(long paths, long seed) {
        var bounds = slab.bounds();
        Ray ray = Ray.of(new Vec3(0, mu > 0 ? bounds.maxY() : bounds.minY(), 0), eye());
        double scattered = phase.perSteradian(Deflection.separation(eye(), sun()));
        return RandomMean.of(paths, seed, random -> scattered * sunlight(ray, random));
    }

    private double sunlight(Ray ray, SplittableRandom random) {
        double at = MajorantTracking.collision(slab, ray, 0, INFINITE, random);
        return at == INFINITE
                ? 0
                : MajorantTracking.transmittance(slab, Ray.of(ray.at(at), sun()), 0, INFINITE, random);
    }
}
