package nephele.engine.reference.sky;

import java.util.List;
import java.util.Optional;
import nephele.engine.asset.AssetSource;
import nephele.engine.cloud.field.CloudMedium;
import nephele.engine.level.Environment;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.reference.volume.CloudMedia;
import nephele.engine.reference.volume.Surroundings;
import org.joml.Vector3d;

/**
 * The clouds of a level and the light around them, without the level's surfaces. The level is flat for them: a place's
 * height above the planet is its y. Immutable.
 */
public final class LevelClouds {
    private final CloudMedia media;
    private final Surroundings open;

    private LevelClouds(CloudMedia media, Surroundings open) {
        this.media = media;
        this.open = open;
    }

    /**
     * Returns the clouds of an environment; empty if none of them can be seen.
     *
     * @param environment with the sun of its hour
     * @param sky what eyes see; empty for black
     * @throws nephele.engine.asset.AssetException if the picture or grid of a cloud is unusable
     */
    public static Optional<LevelClouds> of(Environment environment, AssetSource assets, Optional<SkyRadiance> sky) {
        List<CloudMedium> media = environment.clouds().stream()
                .filter(cloud -> cloud.extinctionPerMetre() > 0)
                .map(cloud -> CloudMedium.of(cloud, assets))
                .filter(medium -> !medium.field().bounds().isEmpty())
                .toList();
        return media.isEmpty()
                ? Optional.empty()
                : Optional.of(new LevelClouds(new CloudMedia(media), open(environment, sky)));
    }

    private static Surroundings open(Environment environment, Optional<SkyRadiance> sky) {
        Vec3 towardsSun = environment.sun() == null
                ? new Vec3(0, 1, 0)
                : Directions.unit(environment.sun().directionTowardsSun());
        SkyRadiance seen = sky.orElse((height, x, y, z) -> new Vector3d());
        return new Open(towardsSun, SunAtHeights.of(environment), SkyOfPaths.of(environment, seen));
    }

    public CloudMedia media() {
        return media;
    }

    /** Returns the light around the clouds, with no walls; for any number of threads. */
    public Surroundings open() {
        return open;
    }

    /** Sun and sky above a level without surfaces. */
    private record Open(Vec3 towardsSun, SunAtHeights sun, SkyRadiance sky) implements Surroundings {
        @Override
        public Vec3 sunlight(Vec3 place) {
            return sun.at(place.y());
        }

        @Override
        public Vec3 skylight(Vec3 from, Vec3 direction) {
            return Vec3.of(sky.from(from.y(), direction.x(), direction.y(), direction.z()));
        }

        @Override
        public boolean isSunBlocked(Ray ray) {
            return false;
        }

        @Override
        public boolean isPathBlocked(Ray ray, double toMetres) {
            return false;
        }
    }
}
