package nephele.engine.reference.sky;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import nephele.engine.asset.AssetSource;
import nephele.engine.cloud.field.CloudMedium;
import nephele.engine.cloud.field.LoadedClouds;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.reference.volume.CloudMedia;
import nephele.engine.reference.volume.OutsideLight;
import nephele.engine.reference.volume.Surroundings;
import nephele.engine.reference.volume.VolumeTracer;
import org.joml.Vector3d;

/** The clouds of a level at a time and the light around them, without the level's surfaces. Immutable. */
public final class LevelClouds {
    private static final SkyRadiance BLACK = (height, x, y, z) -> new Vector3d();

    private final CloudMedia media;
    private final CloudMedia shafts;
    private final Surroundings open;

    private LevelClouds(CloudMedia media, CloudMedia shafts, Surroundings open) {
        this.media = media;
        this.shafts = shafts;
        this.open = open;
    }

    /**
     * Returns the clouds of an environment; empty if none of them can be seen.
     *
     * @param environment with the sun of the time
     * @param seconds simulated time
     * @param sky what eyes see; empty for black
     * @throws nephele.engine.asset.AssetException if the picture or grid of a cloud is unusable
     */
    public static Optional<LevelClouds> of(
            Environment environment, AssetSource assets, double seconds, Optional<SkyRadiance> sky) {
        LoadedClouds loaded = LoadedClouds.of(environment, assets);
        List<CloudMedium> all = loaded.at(seconds);
        List<CloudMedium> media =
                all.stream().filter(medium -> !medium.field().isEmpty()).toList();
        if (media.isEmpty()) {
            return Optional.empty();
        }
        List<CloudMedium> shafts = IntStream.range(0, all.size())
                .filter(i -> loaded.clouds().get(i).shafts())
                .mapToObj(all::get)
                .filter(media::contains)
                .toList();
        boolean isRound = environment.sky() instanceof Sky.Atmosphere && environment.sun() != null;
        Surroundings open = isRound
                ? OverPlanet.of(environment, groundFraction(environment, loaded, seconds))
                : plain(environment.sun(), sky.orElse(BLACK));
        return Optional.of(new LevelClouds(new CloudMedia(media), new CloudMedia(shafts), open));
    }

    private static double groundFraction(Environment environment, LoadedClouds loaded, double seconds) {
        var sky = (Sky.Atmosphere) environment.sky();
        double sine = Directions.unit(Daylight.onGround(environment).directionTowardsSun())
                .y();
        return loaded.groundFraction(seconds, Vec3.ZERO, sine, sky.groundAlbedo());
    }

    private static Surroundings plain(Sun sun, SkyRadiance sky) {
        return sun == null ? OutsideLight.of(sky) : OutsideLight.of(sun.directionTowardsSun(), sun.irradiance(), sky);
    }

    public CloudMedia media() {
        return media;
    }

    /** Returns those of the clouds that cast shadows into the air. */
    public CloudMedia shafts() {
        return shafts;
    }

    /** Returns the light around the clouds, with no walls; for any number of threads. */
    public Surroundings open() {
        return open;
    }

    /** Returns the tracer of a sky without surfaces; for any number of threads. */
    public VolumeTracer inTheOpen() {
        return new VolumeTracer(media, open);
    }

    /** Returns how far a ray of unit direction can meet clouds. */
    public double reachMetres(Ray ray) {
        return open.reachMetres(ray);
    }
}
