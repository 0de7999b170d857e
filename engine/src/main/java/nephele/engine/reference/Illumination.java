package nephele.engine.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Function;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.LuminanceHistogram;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.math.Aabb;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.reference.SampleSequence.PixelSample;
import nephele.engine.reference.SampleSequence.Point;
import nephele.engine.reference.sky.SkyCover;
import nephele.engine.reference.volume.DistantLight;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The light at a point: one ray to each light, a few of many to the sky. Light does not pass through portals. Clouds dim
 * light that casts shadows; the sky's light is what comes through and from them, times the part of the sky that surfaces
 * leave visible.
 */
final class Illumination {
    /** Rays per sample towards the sky; in a room with a small window few of them reach it. */
    static final int SKY_RAYS = 4;

    private static final int SUN = 0;
    private static final int FIRST_LIGHT = 1;

    /** The height of the rays' origins above their face: above rounding errors, below any visible thickness. */
    private static final double LIFT_METRES = 1e-7;

    private final Sun sun;
    private final Vector3dc towardsSun;
    private final List<PunctualLight> lights;
    private final Vec3 ambient;
    private final SkyCover cover;

    Illumination(Level level, SkyCover cover) {
        Environment environment = level.environment();
        sun = Daylight.onGround(environment);
        towardsSun = sun == null ? new Vector3d() : unit(sun.directionTowardsSun());
        lights = level.lights().stream()
                .flatMap(light -> PunctualLight.of(light).stream())
                .toList();
        ambient = environment.ambient();
        this.cover = cover;
    }

    /** Returns for each light but the sky the function from a box to the shaft of its shadow rays. */
    List<Function<Aabb, ShaftShape>> shafts() {
        Vec3 sunwards = Vec3.of(towardsSun);
        List<Function<Aabb, ShaftShape>> shafts = new ArrayList<>();
        shafts.add(from -> ShaftShape.along(sunwards, sunwards, from));
        lights.forEach(light -> shafts.add(from -> ShaftShape.to(light.position(), from)));
        return shafts;
    }

    private static Vector3dc unit(Vec3 v) {
        return Directions.unit(v).toVector();
    }

    /**
     * Returns the radiance towards the eye.
     *
     * @param sample chooses the rays towards the sky
     */
    Vector3d radiance(SurfacePoint surface, Shafts.ShadowRays shadows, PixelSample sample) {
        Vector3d sum = direct(surface, shadows, sample).add(constantAmbient(surface));
        if (ambient == null && !cover.isDark()) {
            addSky(surface, lifted(surface), shadows, sample, sum);
        }
        Vec3 own = surface.emission();
        return sum.min(new Vector3d(LuminanceHistogram.LARGEST_HALF)).add(own.x(), own.y(), own.z());
    }

    /** Returns the radiance towards the eye by sun and lamps. */
    Vector3d direct(SurfacePoint surface, Shafts.ShadowRays shadows, PixelSample sample) {
        Vector3d sum = new Vector3d();
        Vector3d origin = lifted(surface);
        if (sun != null) {
            addSun(surface, origin, shadows, sample, sum);
        }
        for (int light = 0; light < lights.size(); light++) {
            addLight(light, surface, origin, shadows, sample, sum);
        }
        return sum;
    }

    /** Returns the radiance towards the eye by the level's constant ambient light; black if its sky lights it instead. */
    Vector3d constantAmbient(SurfacePoint surface) {
        if (ambient == null) {
            return new Vector3d();
        }
        Vector3d all = ambient.toVector();
        return surface.reflected(all, all);
    }

    /** Returns the unit direction; meaningless without a sun. */
    Vector3dc towardsSun() {
        return towardsSun;
    }

    /** Returns the sun if it casts shadows. */
    List<DistantLight> castingSun() {
        return sun != null && sun.castsShadow()
                ? List.of(new DistantLight.Even(Vec3.of(towardsSun), sun.irradiance()))
                : List.of();
    }

    List<PunctualLight> lamps() {
        return lights;
    }

    /** Returns true if the sky is a light: the level has no constant ambient light in its place. */
    boolean isSkyLight() {
        return ambient == null;
    }

    /** Returns a random number whose mean is the fraction of light that passes the clouds before a place. */
    double passedByClouds(Vector3dc place, Vector3dc towardsLight, double metres, SplittableRandom random) {
        return cover.fraction(place, towardsLight, metres, random);
    }

    /** Returns the origin of shadow rays. Far from the world's origin the spacing of doubles exceeds the usual lift. */
    static Vector3d lifted(SurfacePoint surface) {
        Vector3d p = surface.place().toVector();
        double largest = Math.max(Math.abs(p.x), Math.max(Math.abs(p.y), Math.abs(p.z)));
        return p.fma(Math.max(LIFT_METRES, 8 * Math.ulp(largest)), surface.faceNormal());
    }

    /** Adds the light of the sun. */
    void addSun(SurfacePoint surface, Vector3d origin, Shafts.ShadowRays shadows, PixelSample sample, Vector3d sum) {
        if (surface.isTowards(towardsSun)
                && !(sun.castsShadow()
                        && shadows.isBlocked(SUN, origin, towardsSun, Double.POSITIVE_INFINITY, surface.item()))) {
            double fraction = sun.castsShadow()
                    ? cover.fraction(origin, towardsSun, Double.POSITIVE_INFINITY, sample.random())
                    : 1;
            sum.add(surface.sunlit(towardsSun).mul(sun.irradiance().toVector()).mul(fraction));
        }
    }

    /** Adds the light of a lamp. */
    void addLight(
            int index,
            SurfacePoint surface,
            Vector3d origin,
            Shafts.ShadowRays shadows,
            PixelSample sample,
            Vector3d sum) {
        PunctualLight light = lights.get(index);
        Vector3d toLight = light.position().toVector().sub(origin);
        double distance = toLight.length();
        if (distance >= light.rangeMetres() || surface.faceNormal().dot(toLight) <= 0) {
            return;
        }
        Vector3d irradiance = light.irradianceAt(surface.place());
        boolean isDark = irradiance.x + irradiance.y + irradiance.z == 0;
        boolean casts = light.source().castsShadow();
        if (!isDark && !(casts && shadows.isBlocked(FIRST_LIGHT + index, origin, toLight, 1, surface.item()))) {
            toLight.div(distance);
            double fraction = casts ? cover.fraction(origin, toLight, distance, sample.random()) : 1;
            sum.add(surface.reflected(toLight).mul(irradiance).mul(fraction));
        }
    }

    private void addSky(
            SurfacePoint surface, Vector3d origin, Shafts.ShadowRays shadows, PixelSample sample, Vector3d sum) {
        Vector3d across =
                Directions.perpendicular(Vec3.of(surface.smoothNormal())).toVector();
        Vector3d up = new Vector3d(surface.smoothNormal()).cross(across);
        int free = 0;
        for (int i = 0; i < SKY_RAYS; i++) {
            Vector3d direction = onHemisphere(sample.sky(i), across, up, surface.smoothNormal());
            if (surface.smoothNormal() != surface.faceNormal()) {
                layAbove(direction, surface.faceNormal());
            }
            boolean isBlocked = shadows.isSkyBlocked(origin, direction, surface.item());
            free += isBlocked ? 0 : 1;
        }
        if (free > 0) {
            Vector3d onNormal = cover.skylight(origin, surface.normal(), sample.random());
            Vector3d mirrored = surface.gloss() == null
                    ? onNormal
                    : cover.skylight(origin, surface.mirrorDirection(), sample.random());
            sum.fma((double) free / SKY_RAYS, surface.reflected(onNormal, mirrored));
        }
    }

    /**
     * Projects a direction of the curve's hemisphere that is below its triangle's plane onto that plane: the triangle
     * itself does not occlude it.
     */
    private static void layAbove(Vector3d direction, Vector3dc faceNormal) {
        direction.fma(-Math.min(direction.dot(faceNormal), 0), faceNormal);
    }

    /** Returns directions of equal cosine weight for equal areas of the unit square (Malley's method). */
    private static Vector3d onHemisphere(Point point, Vector3d across, Vector3d up, Vector3dc normal) {
        double radius = Math.sqrt(point.x());
        double angle = 2 * Math.PI * point.y();
        return new Vector3d(normal)
                .mul(Math.sqrt(1 - point.x()))
                .fma(radius * StrictMath.cos(angle), across)
                .fma(radius * StrictMath.sin(angle), up);
    }
}
