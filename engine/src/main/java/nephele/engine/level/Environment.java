package nephele.engine.level;

import java.util.List;
import nephele.engine.math.Vec3;

/**
 * Sun, sky, clouds, fog and the exposure and tone curve of the picture.
 *
 * @param sun {@code null} for none
 * @param sky {@code null} for black
 * @param ambient constant radiance that every surface receives from all directions (a surface reflects albedo ×
 * ambient) instead of sky irradiance × baked visibility; {@code null} for sky and visibility
 * @param exposureStops a number, or auto
 * @param fog {@code null} for none
 * @param weather clouds that the engine adds to the written ones; {@code null} for none
 * @param weatherKeyframes weathers at times, in the place of one weather; between two, one fades into the other
 */
public record Environment(
        @Written Sun sun,
        @Written Sky sky,
        @Written(min = 0, max = 1e9) Vec3 ambient,
        @Written(min = -32, max = 32, absent = "0") Exposure exposureStops,
        @Written(absent = "\"clip\"") ToneCurve toneCurve,
        @Written Fog fog,
        @Written(most = 1000) List<Cloud> clouds,
        @Written Weather weather,
        @Written(min = -9.007199254740991e15, max = 9.007199254740991e15) long weatherSeed,
        @Written(most = 1000) List<WeatherKeyframe> weatherKeyframes) {

    /**
     * A weather at a time.
     *
     * @param timeSeconds simulated time
     */
    public record WeatherKeyframe(
            @Written(required = true, min = 0, max = 1e9) double timeSeconds,
            @Written(required = true, prototype = "\"few\"") Weather weather) {}

    /** Creates an environment without weather. */
    public Environment(
            Sun sun, Sky sky, Vec3 ambient, Exposure exposureStops, ToneCurve toneCurve, Fog fog, List<Cloud> clouds) {
        this(sun, sky, ambient, exposureStops, toneCurve, fog, clouds, null, 0, List.of());
    }

    /** Creates an environment with one weather. */
    public Environment(
            Sun sun,
            Sky sky,
            Vec3 ambient,
            Exposure exposureStops,
            ToneCurve toneCurve,
            Fog fog,
            List<Cloud> clouds,
            Weather weather,
            long weatherSeed) {
        this(sun, sky, ambient, exposureStops, toneCurve, fog, clouds, weather, weatherSeed, List.of());
    }

    public Environment with(Sun newSun) {
        return new Environment(
                newSun, sky, ambient, exposureStops, toneCurve, fog, clouds, weather, weatherSeed, weatherKeyframes);
    }

    public Environment with(Sky newSky) {
        return new Environment(
                sun, newSky, ambient, exposureStops, toneCurve, fog, clouds, weather, weatherSeed, weatherKeyframes);
    }

    public Environment with(Exposure exposure) {
        return new Environment(
                sun, sky, ambient, exposure, toneCurve, fog, clouds, weather, weatherSeed, weatherKeyframes);
    }

    public Environment withClouds(List<Cloud> written) {
        return new Environment(
                sun, sky, ambient, exposureStops, toneCurve, fog, written, weather, weatherSeed, weatherKeyframes);
    }

    public Environment withAmbient(Vec3 radiance) {
        return new Environment(
                sun, sky, radiance, exposureStops, toneCurve, fog, clouds, weather, weatherSeed, weatherKeyframes);
    }

    public Environment withFog(Fog newFog) {
        return new Environment(
                sun, sky, ambient, exposureStops, toneCurve, newFog, clouds, weather, weatherSeed, weatherKeyframes);
    }

    /** Returns this environment with a weather that stays; {@code null} for none. */
    public Environment with(Weather newWeather, long seed) {
        return new Environment(sun, sky, ambient, exposureStops, toneCurve, fog, clouds, newWeather, seed);
    }

    /** Returns this environment without clouds, those of its weather included. */
    public Environment withoutClouds() {
        return new Environment(sun, sky, ambient, exposureStops, toneCurve, fog, List.of(), null, 0);
    }
}
