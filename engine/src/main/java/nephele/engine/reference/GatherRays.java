package nephele.engine.reference;

import java.util.SplittableRandom;
import nephele.engine.math.Vec3;
import nephele.engine.reference.SampleSequence.PixelSample;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The rays with which a bake gathers light: the path tracer's own, one segment at a time. Use one per thread; the
 * accessors refer to the last ray.
 */
public final class GatherRays {
    /** Up to here air gives about as much light as it takes; to integrate it takes longer than to trace the ray. */
    private static final double AIRLESS_METRES = 2000;

    /** The share of a source's radiance, before shadows, that is worth a shadow ray each time. */
    private static final double SURE_SHARE = 0.01;

    private static final Vector3dc WHITE = new Vector3d(1);

    private final TracedLevel level;
    private final EyePath path;
    private final Shafts.ShadowRays shadows;
    /** {@code null} without clouds. */
    private final CloudSight clouds;

    /** {@code null} if each ray finds the sky itself. */
    private final SkyPanorama panorama;

    private final Sources sources;
    private final Vector3d arriving = new Vector3d();
    /** The share of the light of the ray's end that arrives. */
    private final Vector3d passed = new Vector3d();

    private final Vector3d emitted = new Vector3d();
    private final Vector3d reflectance = new Vector3d();
    private final Vector3d towards = new Vector3d();
    private Vec3 place;
    /** {@code null} unless a surface was met. */
    private SurfacePoint surface;

    /** The sources whose light is gathered. */
    public enum Sources {
        ALL,
        /** Lamps and emission: what stays when sun and sky change with time. */
        LAMPS
    }

    /** The kinds of things at which a ray ends. */
    public enum End {
        /** Nothing or a cloud. */
        OPEN,
        SOLID,
        MODEL,
        GROUND,
        /** A surface that no light is baked on. */
        OTHER
    }

    GatherRays(TracedLevel level, EyePath path, Sources sources, SkyPanorama panorama, Shafts.ShadowRays shadows) {
        this.level = level;
        this.path = path;
        this.panorama = panorama;
        this.sources = sources;
        this.shadows = shadows;
        clouds = sources == Sources.ALL && panorama == null ? level.cloudSight().orElse(null) : null;
    }

    /**
     * Traces a ray off mirrors to the first surface.
     *
     * @param origin above the surface from which it leaves
     * @param direction unit
     */
    public End trace(Vector3dc origin, Vector3dc direction, SplittableRandom random) {
        surface = null;
        emitted.zero();
        reflectance.zero();
        boolean isMet = path.trace(origin, direction, 0, Double.POSITIVE_INFINITY);
        if (!isMet && panorama != null) {
            arriving.set(panorama.at(path.direction())).mul(path.tint());
            return End.OPEN;
        }
        CloudSight.Met cloud = clouds == null ? null : clouds.first(path, random);
        arriving.zero();
        passed.set(path.tint());
        if (cloud != null || path.metres() > AIRLESS_METRES) {
            PathAir air = level.air(cloud == null ? path.partsToEnd() : cloud.parts(), random);
            arriving.set(sources == Sources.ALL ? air.added() : new Vector3d());
            passed.set(air.passed());
        }
        if (cloud != null) {
            arriving.add(clouds.radiance(cloud, random).mul(passed));
            return End.OPEN;
        }
        if (!isMet) {
            if (sources == Sources.ALL && level.light().isSkyLight()) {
                arriving.add(level.skyOfPath(path.lastSegment(), random).mul(passed));
            }
            return End.OPEN;
        }
        place = path.ray().at(path.end());
        surface = level.surface(path, place, new Vector3d(path.direction()).normalize(-1))
                .reciprocal();
        emitted.set(surface.emission().toVector()).mul(passed);
        reflectance
                .set(
                        surface.gloss() == null
                                ? surface.albedo()
                                : surface.gloss().diffuse())
                .add(surface.gloss() == null ? new Vector3d() : surface.gloss().ambientSpecular())
                .mul(passed);
        return level.endOf(path.item());
    }

    /** Returns the RGB radiance that arrives along the ray from the sky, from clouds, and from the air before its end. */
    public Vector3dc arriving() {
        return arriving;
    }

    /** Returns the RGB radiance that arrives of what the ray's end emits. */
    public Vector3dc emitted() {
        return emitted;
    }

    /** Returns the RGB radiance that arrives for each unit of irradiance / π at the ray's end. */
    public Vector3dc reflectance() {
        return reflectance;
    }

    /** Returns true if {@link #emission} may find anything. */
    public boolean hasEmissive() {
        return !level.emissive().isEmpty();
    }

    /** Returns the place of the ray's end. */
    public Vec3 place() {
        return place;
    }

    /** Returns the unit normal of the geometry at the ray's end. */
    public Vector3dc normal() {
        return surface.faceNormal();
    }

    /** Returns the index of the solid, model or terrain at the ray's end. */
    public int index() {
        return level.indexOf(path.item());
    }

    /** Returns the face of the solid at the ray's end, or the triangle of the model. */
    public int part() {
        return level.partOf(path);
    }

    /**
     * Returns the irradiance / π of one light straight on a surface; random where clouds are before it.
     *
     * @param light −1 for the sun, else the index of a lamp among those that emit
     */
    public Vector3d direct(int light, Vec3 on, Vector3dc normal, SplittableRandom random) {
        SurfacePoint white = new SurfacePoint(-1, on, normal, normal, normal, WHITE, null, normal, Vec3.ZERO, false);
        Vector3d sum = new Vector3d();
        PixelSample sample = new SampleSequence(random.nextLong()).sample(0, 0, 0);
        if (light < 0) {
            towards.set(level.light().towardsSun());
            level.light().addSun(white, Illumination.lifted(white), shadows, sample, sum);
        } else {
            towards.set(level.light().lamps().get(light).position().toVector()).sub(on.x(), on.y(), on.z());
            towards.normalize();
            level.light().addLight(light, white, Illumination.lifted(white), shadows, sample, sum);
        }
        return sum;
    }

    /** Returns the unit direction to the light of the last {@link #direct} or {@link #emission}. */
    public Vector3dc towards() {
        return towards;
    }

    /**
     * Returns a random irradiance / π from one point of the emissive surfaces, weighted for rays whose density is the cosine
     * / π by the power heuristic (Veach 1997, section 9.2.4).
     */
    public Vector3d emission(Vec3 on, Vector3dc normal, SplittableRandom random) {
        EmissiveSurfaces.Source source = level.emissive().source(random);
        if (source == null) {
            return new Vector3d();
        }
        SurfacePoint white = new SurfacePoint(-1, on, normal, normal, normal, WHITE, null, normal, Vec3.ZERO, false);
        Vector3d origin = Illumination.lifted(white);
        towards.set(source.place().toVector()).sub(origin);
        double distance = towards.length();
        towards.div(distance);
        double there = -towards.dot(source.normal().toVector());
        double here = normal.dot(towards);
        if (there <= 0 || here <= 0) {
            return new Vector3d();
        }
        double density = source.density() * distance * distance / there;
        double ratio = here / Math.PI / density;
        double share = here / (Math.PI * density) / (1 + ratio * ratio);
        // Most surfaces of a large level are far from most lamps: few of their shadow rays are worth their cost.
        double survival = Math.min(1, share / SURE_SHARE);
        if (random.nextDouble() >= survival || shadows.isBlockedWithin(origin, towards, distance, -1)) {
            return new Vector3d();
        }
        return source.radiance().toVector().mul(share / survival);
    }

    /** Returns the weight of {@link #emitted} beside {@link #emission}; the ray's density was its cosine / π. */
    public double emittedWeight(double cosine, Vector3dc origin) {
        double there = surface.faceNormal().dot(surface.toEye());
        double perSquareMetre = path.pathHash() == 0 ? level.emissive().density(path) : 0;
        if (perSquareMetre == 0 || there <= 0) {
            return 1;
        }
        double squareDistance = place.toVector().distanceSquared(origin);
        double ratio = perSquareMetre * squareDistance / there / (cosine / Math.PI);
        return 1 / (1 + ratio * ratio);
    }
}
