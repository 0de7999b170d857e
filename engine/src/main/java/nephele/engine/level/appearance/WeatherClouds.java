package nephele.engine.level.appearance;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Cloud;
import nephele.engine.level.Cloud.Density.Noise;
import nephele.engine.level.CloudProfile;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Weather;
import nephele.engine.math.Hash64;
import nephele.engine.math.Vec3;

/**
 * The clouds that an environment has altogether, and those that its weather means. An instance makes the genera of
 * clouds as layers, with altitudes, covers and winds that vary with a seed.
 */
public final class WeatherClouds {
    /** Prefix of the ids of a weather's clouds. */
    public static final String ID_PREFIX = "weather-";

    private static final double WATER_G = 0.85;
    private static final double ICE_G = 0.8;

    /** Makes a weather's numbers others than those that clouds derive from the same seed: "weather" in ASCII. */
    private static final long SALT = 0x77656174686572L;

    /** A picture of the program's own assets. */
    private static final String STREAKS = "textures/clouds/streaks.png";

    private final long seed;

    private WeatherClouds(long seed) {
        this.seed = seed;
    }

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
        var layers = new WeatherClouds(seed);
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

    /** Fair-weather cumulus, wider than high. */
    private Cloud humilis() {
        var noise = noise(between(1, 220, 300, 10), between(2, 0.16, 0.22, 0.01), 0.5, CloudProfile.CUMULUS, 0);
        return water(
                "cumulus", new Cloud.Extent.Layer(between(3, 1000, 1500, 50), between(4, 500, 800, 50)), noise, 0.06);
    }

    /** Cumulus about as high as wide. */
    private Cloud mediocris() {
        var noise = noise(between(1, 340, 440, 10), between(2, 0.36, 0.46, 0.01), 0.5, CloudProfile.CUMULUS, 0);
        return water(
                "cumulus", new Cloud.Extent.Layer(between(3, 900, 1300, 50), between(4, 1000, 1500, 50)), noise, 0.07);
    }

    /** A broken low sheet. */
    private Cloud stratocumulus() {
        var noise = noise(between(1, 480, 620, 20), between(2, 0.68, 0.78, 0.01), 0.6, CloudProfile.STRATUS, 0);
        return water(
                "stratocumulus",
                new Cloud.Extent.Layer(between(3, 900, 1200, 50), between(4, 450, 600, 50)),
                noise,
                0.05);
    }

    /** Flakes of a thin sheet at middle height. */
    private Cloud altocumulus() {
        var noise = noise(between(5, 160, 220, 10), between(6, 0.4, 0.55, 0.01), 0.5, CloudProfile.STRATUS, 0);
        return water("altocumulus", new Cloud.Extent.Layer(between(7, 3200, 4500, 100), 200), noise, 0.02);
    }

    /** A closed low sheet. */
    private Cloud stratus() {
        var noise = noise(between(1, 800, 1100, 50), 1, 0.3, CloudProfile.STRATUS, 0);
        return water(
                "stratus", new Cloud.Extent.Layer(between(3, 600, 900, 50), between(4, 450, 650, 50)), noise, 0.04);
    }

    /** Torn low cloud under a cover. */
    private Cloud scud(double coverage) {
        var noise = noise(between(8, 240, 320, 10), coverage, 1, CloudProfile.STRATUS, 0);
        return water("scud", new Cloud.Extent.Layer(between(9, 350, 450, 10), 150), noise, 0.015);
    }

    /** Towers with anvils. */
    private Cloud cumulonimbus() {
        var noise =
                noise(between(1, 1200, 1500, 50), between(2, 0.88, 0.94, 0.01), 0.6, CloudProfile.CUMULONIMBUS, 0.8);
        return water(
                "cumulonimbus",
                new Cloud.Extent.Layer(between(3, 600, 900, 50), between(4, 8500, 9800, 100)),
                noise,
                0.06);
    }

    /** Streaks of ice. */
    private Cloud cirrus() {
        return ice("cirrus", new Cloud.Extent.Layer(between(10, 8000, 9500, 100), 700), streaks(1), 1.2e-3);
    }

    /** Wisps high above other clouds. */
    private Cloud thinCirrus() {
        return ice("cirrus", new Cloud.Extent.Layer(between(10, 8500, 9800, 100), 600), streaks(0.7), 6e-4);
    }

    private Noise noise(double featureMetres, double coverage, double erosion, CloudProfile profile, double anvil) {
        return new Noise(seed, featureMetres, coverage, erosion, profile, null, anvil);
    }

    private Noise streaks(double coverage) {
        return new Noise(seed, between(11, 15_000, 20_000, 1000), coverage, 0, null, STREAKS, 0);
    }

    private Cloud water(String genus, Cloud.Extent.Layer extent, Noise noise, double extinctionPerMetre) {
        return cloud(genus, extent, noise, extinctionPerMetre, WATER_G);
    }

    private Cloud ice(String genus, Cloud.Extent.Layer extent, Noise noise, double extinctionPerMetre) {
        return cloud(genus, extent, noise, extinctionPerMetre, ICE_G);
    }

    /** Lets the wind grow with altitude, and the cloud take another shape while it drifts some of its features. */
    private Cloud cloud(String genus, Cloud.Extent.Layer extent, Noise noise, double extinctionPerMetre, double g) {
        double metresPerSecond = Math.rint(between(14, 4, 9, 1) + extent.baseAltitudeMetres() / 500);
        double across = between(15, -2, 2, 1);
        double evolutionSeconds = Math.rint(4 * noise.featureMetres() / metresPerSecond);
        return new Cloud(
                ID_PREFIX + genus,
                extent,
                CloudTechnique.AUTO,
                noise,
                extinctionPerMetre,
                1,
                g,
                new Cloud.Motion(new Vec3(metresPerSecond, 0, across), evolutionSeconds));
    }

    /**
     * Returns a multiple of {@code step} in a range, as the number that a designer would write.
     *
     * @param key tells the random numbers of a seed apart
     */
    private double between(int key, double from, double to, double step) {
        double unit = (Hash64.combine(Hash64.combine(seed, SALT), key) >>> 11) * 0x1p-53;
        double at = Math.rint((from + unit * (to - from)) / step) * step;
        return Math.rint(at * 100) / 100;
    }
}
