package nephele.engine.reference.sky;

import java.util.Optional;
import java.util.SplittableRandom;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.reference.volume.VolumeTracer;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Clouds and air between the surfaces of a level and the light that falls on them. For any number of threads. */
public sealed interface SkyCover {
    /**
     * Returns a random number in 0 to 1 whose mean is the fraction of a light that passes the clouds before a place.
     *
     * @param towardsLight unit
     * @param metres to the light; infinite for the sun
     */
    double fraction(Vector3dc place, Vector3dc towardsLight, double metres, SplittableRandom random);

    /**
     * Returns a random RGB value whose mean is irradiance / π of a surface from the sky, through and from the clouds, if
     * no surface hides a part of it.
     *
     * @param normal unit
     */
    Vector3d skylight(Vector3dc place, Vector3dc normal, SplittableRandom random);

    /** Returns true if the sky gives no light. */
    boolean isDark();

    /** Returns the cover of a level with clouds, or of one without. */
    static SkyCover of(Optional<LevelClouds> clouds, Optional<SkyRadiance> sky) {
        return clouds.isPresent() ? new Clouds(clouds.get()) : new Clear(sky.map(SkyLight::new));
    }

    /** No clouds: the sky's irradiance is a table. */
    record Clear(Optional<SkyLight> light) implements SkyCover {
        @Override
        public boolean isDark() {
            return light.isEmpty();
        }

        @Override
        public double fraction(Vector3dc place, Vector3dc towardsLight, double metres, SplittableRandom random) {
            return 1;
        }

        @Override
        public Vector3d skylight(Vector3dc place, Vector3dc normal, SplittableRandom random) {
            return light.map(table -> table.ambient(normal)).orElseGet(Vector3d::new);
        }
    }

    /** Clouds: a random walk for each sample of the irradiance. */
    record Clouds(LevelClouds clouds, VolumeTracer tracer) implements SkyCover {
        Clouds(LevelClouds clouds) {
            this(clouds, clouds.inTheOpen());
        }

        @Override
        public boolean isDark() {
            return false;
        }

        @Override
        public double fraction(Vector3dc place, Vector3dc towardsLight, double metres, SplittableRandom random) {
            Ray ray = ray(place, Vec3.of(towardsLight));
            return clouds.media().transmittance(ray, 0, Math.min(metres, clouds.reachMetres(ray)), random);
        }

        @Override
        public Vector3d skylight(Vector3dc place, Vector3dc normal, SplittableRandom random) {
            return tracer.radiance(ray(place, aroundNormal(Vec3.of(normal), random)), random)
                    .toVector();
        }

        private static Ray ray(Vector3dc place, Vec3 direction) {
            return Ray.of(Vec3.of(place), direction);
        }

        /** Returns a random unit direction of density cosine / π (Malley's method). */
        private static Vec3 aroundNormal(Vec3 normal, SplittableRandom random) {
            Vec3 across = Directions.perpendicular(normal);
            double square = random.nextDouble();
            double angle = 2 * Math.PI * random.nextDouble();
            Vec3 flat = Directions.combined(across, StrictMath.cos(angle), normal.cross(across), StrictMath.sin(angle));
            return Directions.unit(Directions.combined(normal, Math.sqrt(1 - square), flat, Math.sqrt(square)));
        }
    }
}
