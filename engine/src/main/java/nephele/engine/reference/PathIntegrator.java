package nephele.engine.reference;

import java.util.SplittableRandom;
import nephele.engine.math.Vec3;
import nephele.engine.reference.SampleSequence.PixelSample;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Follows light from a surface back to its sources: a random path over surfaces, with next-event estimation towards sun,
 * lamps and emissive surfaces at each of them. Emission that both the estimation and the path may find is weighted between
 * the two by the power heuristic (Veach 1997, section 9.2.4); weak paths end by Russian roulette, whose survivors are
 * strengthened, so that no number of bounces is the greatest. Use one per thread.
 */
final class PathIntegrator {
    /** The number of bounces before roulette begins. */
    private static final int SURE_BOUNCES = 3;

    private final TracedLevel level;
    private final EyePath path;
    private final Shafts.ShadowRays shadows;
    /** {@code null} without clouds. */
    private final CloudSight clouds;
    /** {@code null} if light passes no portals. */
    private final LightThroughPortals throughPortals;

    private final int mostBounces;
    private final Estimation estimation;
    private final Vector3d weight = new Vector3d();
    private final Vector3d sum = new Vector3d();

    PathIntegrator(TracedLevel level, LightTransport transport, Shafts.ShadowRays shadows, Estimation estimation) {
        this.estimation = estimation;
        this.level = level;
        this.shadows = shadows;
        mostBounces = transport.bounces();
        path = level.path(transport.passesPortals());
        clouds = level.cloudSight().orElse(null);
        throughPortals = transport.passesPortals()
                ? new LightThroughPortals(level.portals(), level.path(true), level.light())
                : null;
    }

    /** Returns a random RGB radiance whose mean is what leaves the surface towards the eye. */
    Vector3d radiance(SurfacePoint visible, PixelSample sample) {
        SplittableRandom random = sample.random();
        weight.set(1);
        sum.set(0).add(emission(visible)).add(level.light().constantAmbient(visible));
        SurfacePoint surface = visible.reciprocal();
        for (int bounce = 0; surface != null; bounce++) {
            addReflected(level.light().direct(surface, shadows, sample));
            if (throughPortals != null) {
                addReflected(throughPortals.radiance(surface, random));
            }
            addEmissive(surface, random);
            SurfacePoint beyond = next(surface, bounce, sample);
            surface = bounce == mostBounces ? null : beyond;
        }
        return new Vector3d(sum);
    }

    private static Vector3d emission(SurfacePoint surface) {
        return surface.emission().toVector();
    }

    private void addReflected(Vector3d radiance) {
        sum.add(radiance.mul(weight));
    }

    /** Adds the light of a random place of the emissive surfaces. */
    private void addEmissive(SurfacePoint surface, SplittableRandom random) {
        EmissiveSurfaces emissive = level.emissive();
        EmissiveSurfaces.Source source = emissive.isEmpty() ? null : emissive.source(random);
        if (source == null) {
            return;
        }
        Vector3d origin = Illumination.lifted(surface);
        Vector3d towards = source.place().toVector().sub(origin);
        double distance = towards.length();
        towards.div(distance);
        double cosine = -towards.dot(source.normal().toVector());
        if (cosine <= 0 || surface.faceNormal().dot(towards) <= 0) {
            return;
        }
        Vector3d reflected = surface.reflected(towards);
        if (sum(reflected) == 0 || shadows.isBlockedWithin(origin, towards, distance, surface.item())) {
            return;
        }
        double density = source.density() * distance * distance / cosine;
        double weighted = estimation.ofAimed(density, new BrdfSampling(surface).density(towards));
        double passed = level.light().passedByClouds(origin, towards, distance, random);
        addReflected(reflected.mul(source.radiance().toVector()).mul(weighted * passed / density));
    }

    /** The rays that count towards what both a ray aimed at it and the path itself may meet; all have the same mean. */
    enum Estimation {
        AIMED,
        MET,
        BOTH;

        /** Returns the weight of what an aimed ray meets, by its density and the path's. */
        double ofAimed(double density, double ofPath) {
            return this == BOTH ? powerHeuristic(density, ofPath) : this == AIMED ? 1 : 0;
        }

        /** Returns the weight of what the path meets, by its density and that of rays aimed there. */
        double ofMet(double density, double ofAimed) {
            return ofAimed == 0 ? 1 : 1 - ofAimed(ofAimed, density);
        }

        private static double powerHeuristic(double density, double other) {
            double ratio = other / density;
            return 1 / (1 + ratio * ratio);
        }
    }

    private static double sum(Vector3dc v) {
        return v.x() + v.y() + v.z();
    }

    /** Returns the surface at the end of a random ray from this one; {@code null} if the path ends. */
    private SurfacePoint next(SurfacePoint surface, int bounce, PixelSample sample) {
        BrdfSampling brdf = new BrdfSampling(surface);
        Vector3d direction = brdf.direction(sample.random());
        if (surface.faceNormal().dot(direction) <= 0) {
            return null;
        }
        double density = brdf.density(direction);
        weight.mul(surface.reflected(direction).div(density));
        if (!survives(bounce, sample.random())) {
            return null;
        }
        boolean isMet = path.trace(Illumination.lifted(surface), direction, 0, Double.POSITIVE_INFINITY);
        CloudSight.Met cloud = clouds == null ? null : clouds.first(path, sample.random());
        if (cloud != null) {
            addReflected(level.fromCloud(cloud, clouds, path, sample.random()));
            return null;
        }
        if (!isMet) {
            addSky(sample.random());
            return null;
        }
        return met(surface, density, sample.random());
    }

    /** Adds the sky at the end of the path, without the sun's disc, which next-event estimation stands for. */
    private void addSky(SplittableRandom random) {
        if (level.light().isSkyLight()) {
            addReflected(level.fromSkyToPath(path, random));
        }
    }

    /** Ends weak paths; the probability to go on is the greatest weight of a channel. */
    private boolean survives(int bounce, SplittableRandom random) {
        double greatest = weight.get(weight.maxComponent());
        if (bounce < SURE_BOUNCES) {
            return greatest > 0;
        }
        double survival = Math.min(1, greatest);
        if (random.nextDouble() >= survival) {
            return false;
        }
        weight.div(survival);
        return true;
    }

    /** Returns the surface at the end of the path, after its emission and that of the air before it are added. */
    private SurfacePoint met(SurfacePoint from, double density, SplittableRandom random) {
        Vec3 place = path.ray().at(path.end());
        SurfacePoint surface = level.surface(path, place, new Vector3d(path.direction()).normalize(-1))
                .reciprocal();
        addReflected(level.arriving(new Vector3d(), place, path, random));
        weight.mul(level.transmittance(place, path));
        Vector3d emission = emission(surface);
        if (sum(emission) > 0) {
            addReflected(emission.mul(emissionWeight(from, surface, density)));
        }
        return surface;
    }

    /** Returns the weight of emission that the path itself meets, beside that of {@link #addEmissive}. */
    private double emissionWeight(SurfacePoint from, SurfacePoint surface, double density) {
        double perSquareMetre = path.pathHash() == 0 ? level.emissive().density(path) : 0;
        double cosine = surface.faceNormal().dot(surface.toEye());
        if (perSquareMetre == 0 || cosine <= 0) {
            return 1;
        }
        double distance = surface.place().minus(from.place()).length();
        return estimation.ofMet(density, perSquareMetre * distance * distance / cosine);
    }
}
