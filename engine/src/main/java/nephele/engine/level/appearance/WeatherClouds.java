package nephele.engine.level.appearance;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Weather;

/** The clouds that an environment has altogether, and those that its weather means. */
public final class WeatherClouds {
    /** Prefix of the ids of a weather's clouds. */
    public static final String ID_PREFIX = "weather-";

    private WeatherClouds() {}

    /** Returns the written clouds, followed by those of the weather or of all weathers of the keyframes. */
    public static List<Cloud> all(Environment environment) {
        return WeatherCourse.of(environment).weathers().isEmpty()
                ? environment.clouds()
                : changing(environment).stream().map(ChangingCloud::cloud).toList();
    }

    /**
     * Returns an environment all whose clouds are drawn by a technique: those of its weather are then written ones, those of
     * keyframes stay as they are.
     */
    public static Environment drawnBy(Environment environment, CloudTechnique technique) {
        boolean stays = environment.weatherKeyframes().isEmpty();
        List<Cloud> clouds = stays ? all(environment) : environment.clouds();
        Environment written = environment.withClouds(
                clouds.stream().map(cloud -> cloud.with(technique)).toList());
        return stays ? written.with((Weather) null, 0) : written;
    }

    /**
     * A cloud of an environment over time.
     *
     * @param weather whose cloud it is; {@code null} for a written one
     */
    public record ChangingCloud(Cloud cloud, Weather weather) {}

    /** Returns the written clouds, followed by those of the weather or of all weathers of the keyframes. */
    public static List<ChangingCloud> changing(Environment environment) {
        List<ChangingCloud> all = new ArrayList<>();
        environment.clouds().forEach(cloud -> all.add(new ChangingCloud(cloud, null)));
        WeatherCourse.of(environment).weathers().forEach(weather -> of(weather, environment.weatherSeed())
                .forEach(cloud -> all.add(new ChangingCloud(cloud, weather))));
        return List.copyOf(all);
    }

    /**
     * Returns the clouds of a weather, from low to high. Covers follow the eighths of the sky that weather reports mean
     * by these words, altitudes the World Meteorological Organization's International Cloud Atlas for temperate
     * latitudes, extinctions of water clouds Hess, Koepke and Schult 1998, "Optical Properties of Aerosols and Clouds",
     * table 4.
     */
    public static List<Cloud> of(Weather weather, long seed) {
        var layers = new WeatherLayers(seed);
        return switch (weather) {
            case CLEAR -> List.of();
            case FEW -> List.of(layers.humilis());
            case SCATTERED -> List.of(layers.mediocris(), layers.thinCirrus());
            case BROKEN -> List.of(layers.stratocumulus(), layers.altocumulus());
            case OVERCAST -> List.of(layers.scud(0.35), layers.stratus());
            case STORM -> List.of(layers.scud(0.4), layers.cumulonimbus());
            case CIRRUS -> List.of(layers.cirrus());
        };
    }
}
