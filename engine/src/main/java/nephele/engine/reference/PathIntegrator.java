package nephele.engine.reference;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.math.Vec3;
import nephele.engine.reference.EyePath.Segment;
import nephele.engine.reference.SampleSequence.PixelSample;
import nephele.engine.reference.volume.DistantLight;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Follows light from a surface or a place in a cloud back to its sources: a random path over such places, with next-event
 * estimation towards sun, lamps and emissive surfaces at each of them. Emission that both the estimation and the path may find is weighted between
 * the two by the power heuristic (Veach 1997, section 9.2.4); weak paths end by Russian roulette, whose survivors are
 * strengthened, so that no number of bounces is the greatest. Use one per thread.
 */
final class PathIntegrator {
    /** The number of turns of a path before roulette begins. */
    private static final int SURE_TURNS = 3;

    private final TracedLevel level;
    private final EyePath path;
    private final Shafts.ShadowRays shadows;
    /** {@code null} without clouds. */
    private final CloudSight clouds;
    /** {@code null} without clouds. */
    private final CloudScattering scattering;

    private final LightImages images;

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
        scattering = level.cloudScattering(transport.passesPortals()).orElse(null);
        images = level.lightImages(transport.passesPortals());
    }

    /** Returns a random RGB radiance whose mean is what leaves the surface towards the eye. */
    Vector3d radiance(SurfacePoint visible, PixelSample sample) {
        weight.set(1);
        sum.set(0).add(emission(visible)).add(level.light().constantAmbient(visible));
        follow(visible.reciprocal(), -1, sample);
        return new Vector3d(sum);
    }

    /** Returns a random RGB radiance whose mean is what a cloud scatters towards the eye at one place. */
    Vector3d radiance(PathVertex.InCloud visible, PixelSample sample) {
        weight.set(1);
        sum.set(0);
        follow(visible, 0, sample);
        return new Vector3d(sum);
    }

    /** Returns a random RGB radiance whose mean, beside that of clouds' places, is what clouds scatter along a path. */
    Vector3d lampsAlong(List<Segment> parts, CloudScattering.Attenuation before, SplittableRandom random) {
        return scattering == null ? new Vector3d() : scattering.lampsAlong(parts, before, random);
    }

    /** @param bounces the number of surfaces that light has met between the path's beginning and this vertex */
    private void follow(PathVertex first, int bounces, PixelSample sample) {
        int surfaces = bounces;
        PathVertex at = first;
        for (int turns = 0; at != null; turns++) {
            if (at instanceof SurfacePoint && ++surfaces > mostBounces) {
                return;
            }
            addDirect(at, sample);
            addEmissive(at, sample.random());
            at = next(at, turns, sample.random());
        }
    }

    /** Adds the light of sun, moon and lamps, and of their images. */
    private void addDirect(PathVertex at, PixelSample sample) {
        List<DistantLight> distant;
        if (at instanceof PathVertex.InCloud inCloud) {
            addReflected(scattering.direct(inCloud, sample.random()));
            distant = scattering.distantLights();
        } else {
            addReflected(level.light().direct((SurfacePoint) at, shadows, sample));
            distant = level.light().castingSun();
        }
        addReflected(images.radiance(at, distant, sample.random()));
    }

    private static Vector3d emission(SurfacePoint surface) {
        return surface.emission().toVector();
    }

    private void addReflected(Vector3d radiance) {
        sum.add(radiance.mul(weight));
    }

    /** Adds the light of a random place of the emissive surfaces. */
    private void addEmissive(PathVertex at, SplittableRandom random) {
        EmissiveSurfaces emissive = level.emissive();
        EmissiveSurfaces.Source source = emissive.isEmpty() ? null : emissive.source(random);
        if (source == null) {
            return;
        }
        Vector3d origin = at.rayOrigin();
        Vector3d towards = source.place().toVector().sub(origin);
        double distance = towards.length();
        towards.div(distance);
        double cosine = -towards.dot(source.normal().toVector());
        if (cosine <= 0 || !at.isReachedFrom(towards)) {
            return;
        }
        Vector3d reflected = at.reflected(towards);
        if (sum(reflected) == 0 || isBlocked(at, origin, towards, distance)) {
            return;
        }
        double density = source.density() * distance * distance / cosine;
        double weighted = estimation.ofAimed(density, at.sampling().density(towards));
        double passed = level.light().passedByClouds(origin, towards, distance, random);
        addReflected(reflected
                .mul(source.radiance().toVector())
                .mul(level.airTransmittance(source.place(), Vec3.of(towards), distance))
                .mul(weighted * passed / density));
    }

    /** Returns true if anything is between a vertex and a place on a face. */
    private boolean isBlocked(PathVertex from, Vector3d origin, Vector3d towards, double distance) {
        return from instanceof SurfacePoint surface
                ? shadows.isBlockedWithin(origin, towards, distance, surface.item())
                : scattering.isBlocked(origin, towards, distance * Shafts.ShadowRays.BEFORE_END);
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

    /** Returns what a random ray from a vertex meets; {@code null} if the path ends. */
    private PathVertex next(PathVertex from, int turns, SplittableRandom random) {
        PathVertex.DirectionSampling sampling = from.sampling();
        Vector3d direction = sampling.direction(random);
        if (!from.isReachedFrom(direction)) {
            return null;
        }
        double density = sampling.density(direction);
        weight.mul(from.reflected(direction).div(density));
        if (!survives(turns, random)) {
            return null;
        }
        boolean isMet = path.leave(from, direction);
        CloudSight.Met cloud = clouds == null ? null : clouds.first(path, random);
        List<Segment> parts = cloud == null ? path.partsToEnd() : cloud.parts();
        // Air within clouds is neither seen nor shaded; the sky as a cloud sees it contains that before it.
        boolean isInAir = from instanceof SurfacePoint || cloud == null && isMet;
        addReflected(lampsAlong(parts, isInAir ? level::airAttenuation : (part, metres) -> part.tint(), random));
        if (isInAir) {
            PathAir air = level.air(parts, random);
            addReflected(air.added());
            weight.mul(air.passed());
        } else {
            weight.mul(parts.get(parts.size() - 1).tint());
        }
        if (cloud != null) {
            return cloud.vertex();
        }
        if (!isMet) {
            addSky(from, random);
            return null;
        }
        return met(from, density);
    }

    /** Adds the sky at the end of the path, without the sun's disc, which next-event estimation stands for. */
    private void addSky(PathVertex from, SplittableRandom random) {
        if (from instanceof PathVertex.InCloud) {
            addReflected(scattering.skylight(path.lastSegment()));
        } else if (level.light().isSkyLight()) {
            addReflected(level.skyOfPath(path.lastSegment(), random));
        }
    }

    /** Ends weak paths; the probability to go on is the greatest weight of a channel. */
    private boolean survives(int turns, SplittableRandom random) {
        double greatest = weight.get(weight.maxComponent());
        if (turns < SURE_TURNS) {
            return greatest > 0;
        }
        double survival = Math.min(1, greatest);
        if (random.nextDouble() >= survival) {
            return false;
        }
        weight.div(survival);
        return true;
    }

    /** Returns the surface at the end of the path, after its emission is added. */
    private SurfacePoint met(PathVertex from, double density) {
        Vec3 place = path.ray().at(path.end());
        SurfacePoint surface = level.surface(path, place, new Vector3d(path.direction()).normalize(-1))
                .reciprocal();
        Vector3d emission = emission(surface);
        if (sum(emission) > 0) {
            addReflected(emission.mul(emissionWeight(from, surface, density)));
        }
        return surface;
    }

    /** Returns the weight of emission that the path itself meets, beside that of {@link #addEmissive}. */
    private double emissionWeight(PathVertex from, SurfacePoint surface, double density) {
        double perSquareMetre = path.pathHash() == 0 ? level.emissive().density(path) : 0;
        double cosine = surface.faceNormal().dot(surface.toEye());
        if (perSquareMetre == 0 || cosine <= 0) {
            return 1;
        }
        double distance = surface.place().minus(from.place()).length();
        return estimation.ofMet(density, perSquareMetre * distance * distance / cosine);
    }
}
