package nephele.engine.reference;

import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.Predicate;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.LightScatteredOnce;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.AirCache;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.ShaftLight;
import nephele.engine.level.appearance.SunAndMoon;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.reference.sky.LevelClouds;
import org.joml.Vector3d;

/**
 * The light that the air in front of what an eye sees lacks in the shadows of clouds and walls: in each part of the path one
 * random point tells how much of the light that is scattered once arrives there. Immutable.
 */
final class AirShade {
    /** Beyond, the air adds no more light; as for what is drawn. */
    private static final double FARTHEST_METRES = 200_000;

    private static final int PARTS = 32;

    private final AirTables tables;
    private final ShaftLight light;
    /** The clouds whose shadows show in the air; {@code null} for none. */
    private final LevelClouds clouds;

    private final Predicate<Ray> walls;

    private AirShade(AirTables tables, ShaftLight light, LevelClouds clouds, Predicate<Ray> walls) {
        this.tables = tables;
        this.light = light;
        this.clouds = clouds;
        this.walls = walls;
    }

    /** Returns the shade of clouds alone, with the sun of an environment's hour; empty if no cloud has shafts. */
    static Optional<AirShade> ofClouds(Environment environment, Optional<LevelClouds> clouds) {
        return !ShaftLight.isIn(environment)
                        || clouds.isEmpty()
                        || clouds.get().shafts().isEmpty()
                ? Optional.empty()
                : of(environment, clouds, ray -> false);
    }

    /**
     * Returns the shade of clouds that have shafts, and of walls; empty without an atmosphere and its sun.
     *
     * @param walls whether any is on a ray towards sun or moon
     */
    static Optional<AirShade> of(Environment environment, Optional<LevelClouds> clouds, Predicate<Ray> walls) {
        if (!(environment.sky() instanceof Sky.Atmosphere sky) || environment.sun() == null) {
            return Optional.empty();
        }
        LevelClouds shading = clouds.filter(all -> !all.shafts().isEmpty()).orElse(null);
        ShaftLight light = ShaftLight.of(SunAndMoon.of(environment));
        return Optional.of(new AirShade(AirCache.tables(Daylight.air(sky)), light, shading, walls));
    }

    /**
     * Returns a random radiance whose mean is what a path lacks.
     *
     * @param eye where the path begins
     * @param direction unit
     * @param metres length of the path; infinite for one that ends in the sky or at the planet's ground
     */
    Vector3d taken(Vec3 eye, Vec3 direction, double metres, SplittableRandom random) {
        double end = Double.isInfinite(metres) ? LightScatteredOnce.metresToEnd(eye.y(), direction.y()) : metres;
        double[] distances = distances(Math.min(FARTHEST_METRES, end));
        Vec3[] upTo = new LightScatteredOnce(tables).upTo(eye.y(), direction, light.towards(), distances);
        Vec3 taken = Vec3.ZERO;
        Vec3 before = Vec3.ZERO;
        double from = 0;
        for (int part = 0; part < PARTS; part++) {
            double at = from + random.nextDouble() * (distances[part] - from);
            Ray ray = Ray.of(eye.addScaled(at, direction), light.towards());
            taken = taken.addScaled(fraction(ray, random), upTo[part].minus(before));
            before = upTo[part];
            from = distances[part];
        }
        return taken.times(light.irradiance()).scaled(light.strength()).toVector();
    }

    /** Returns a random number whose mean is the fraction of light that does not reach a ray's origin. */
    private double fraction(Ray towardsLight, SplittableRandom random) {
        if (walls.test(towardsLight)) {
            return 1;
        }
        return clouds == null
                ? 0
                : 1 - clouds.shafts().transmittance(towardsLight, 0, clouds.reachMetres(towardsLight), random);
    }

    /** Returns the ends of the parts, nearer to each other near the eye. */
    private static double[] distances(double metres) {
        double[] distances = new double[PARTS];
        for (int part = 0; part < PARTS; part++) {
            double fraction = (part + 1.0) / PARTS;
            distances[part] = metres * fraction * fraction;
        }
        return distances;
    }
}
