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
 * @param lightning {@code null} for none
 */
public record Environment(
        @Written Sun sun,
        @Written Sky sky,
        @Written @Range(min = 0, max = 1e9) Vec3 ambient,
        @Written(absent = "0") @Range(min = -32, max = 32) Exposure exposureStops,
        @Written(absent = "\"clip\"") ToneCurve toneCurve,
        @Written Fog fog,
        @Written(most = 1000) List<Cloud> clouds,
        @Written Weather weather,
        @Written @Range(min = -9.007199254740991e15, max = 9.007199254740991e15) long weatherSeed,
        @Written(most = 1000) List<WeatherKeyframe> weatherKeyframes,
        @Written Lightning lightning) {
    /** The last time of the environment's clock: 32 years, at which a double still tells a microsecond. */
    public static final double MOST_SECONDS = 1e9;

    /**
     * Fog: it adds radiance · (1 − exp(−optical depth)) and attenuates what is behind, not the light that surfaces
     * receive. Without a scale height it is the same everywhere and hides the sky, which is at infinite distance. With
     * one it has its extinction up to the base; above, the extinction falls by 1/e in each scale height.
     *
     * @param scaleHeightMetres 0 for fog without end
     */
    public record Fog(
            @Written(required = true) @Range(min = 1e-9, max = 1e3, shape = Range.Shape.OR_ZERO)
                    double extinctionPerMetre,
            @Written(required = true) @Range(min = 0, max = 1e9) Vec3 radiance,
            @Written @Range double baseAltitudeMetres,
            @Written(prototype = "20") @Range(min = 1e-3, max = 1e7, shape = Range.Shape.OR_ZERO)
                    double scaleHeightMetres) {

        /** Creates fog without end. */
        public Fog(double extinctionPerMetre, Vec3 radiance) {
            this(extinctionPerMetre, radiance, 0, 0);
        }

        public boolean isEndless() {
            return scaleHeightMetres == 0;
        }
    }

    /**
     * A weather at a time.
     *
     * @param timeSeconds simulated time
     */
    public record WeatherKeyframe(
            @Written(required = true) @Range(min = 0, max = MOST_SECONDS) double timeSeconds,
            @Written(required = true, prototype = "\"few\"") Weather weather) {}

    /**
     * Strikes of lightning, which are a function of the time alone; nothing that is simulated depends on them.
     *
     * @param strikesPerMinute 0 for none; a strike is seen for little more than a second, and no two at once
     * @param centre of the box of cloud in which bolts start, in metres
     * @param size edges of that box, in metres
     * @param groundAltitudeMetres height at which bolts end that leave the box downwards
     * @param groundShare share of the bolts that strike the ground, 0 to 1; the others end in the box
     * @param radiantIntensity of a whole bolt when its first stroke is brightest, linear RGB, in watts per steradian
     */
    public record Lightning(
            @Written(required = true, prototype = "6") @Range(min = 1e-3, max = 30, shape = Range.Shape.OR_ZERO)
                    double strikesPerMinute,
            @Written @Range(min = 0, max = 1e9) int seed,
            @Written(required = true, spatial = Spatial.POINT) @Range Vec3 centre,
            @Written(required = true, spatial = Spatial.EXTENT, prototype = "[4000, 400, 4000]")
                    @Range(min = 1, max = 1e5)
                    Vec3 size,
            @Written @Range double groundAltitudeMetres,
            @Written(absent = "0.6") @Range(min = 0, max = 1) double groundShare,
            @Written(absent = "[4000000, 4300000, 5200000]") @Range(min = 0, max = 1e9) Vec3 radiantIntensity) {
        /** Returns true if anything of it is ever seen. */
        public boolean strikes() {
            return strikesPerMinute > 0 && !radiantIntensity.equals(Vec3.ZERO);
        }
    }

    /** Creates an environment without lightning. */
    public Environment(
            Sun sun,
            Sky sky,
            Vec3 ambient,
            Exposure exposureStops,
            ToneCurve toneCurve,
            Fog fog,
            List<Cloud> clouds,
            Weather weather,
            long weatherSeed,
            List<WeatherKeyframe> weatherKeyframes) {
        this(sun, sky, ambient, exposureStops, toneCurve, fog, clouds, weather, weatherSeed, weatherKeyframes, null);
    }

    /** Returns true if lightning is seen in it. */
    public boolean hasLightning() {
        return lightning != null && lightning.strikes();
    }

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
        return RecordCopy.with(this, "sun", newSun);
    }

    public Environment with(Sky newSky) {
        return RecordCopy.with(this, "sky", newSky);
    }

    public Environment with(Exposure exposure) {
        return RecordCopy.with(this, "exposureStops", exposure);
    }

    public Environment withClouds(List<Cloud> written) {
        return RecordCopy.with(this, "clouds", written);
    }

    public Environment withAmbient(Vec3 radiance) {
        return RecordCopy.with(this, "ambient", radiance);
    }

    public Environment withFog(Fog newFog) {
        return RecordCopy.with(this, "fog", newFog);
    }

    /** Returns this environment with a weather that stays; {@code null} for none. */
    public Environment with(Weather newWeather, long seed) {
        return RecordCopy.with(this, "weather", newWeather, "weatherSeed", seed, "weatherKeyframes", List.of());
    }

    /** Returns this environment without clouds, those of its weather included. */
    public Environment withoutClouds() {
        return RecordCopy.with(
                this, "clouds", List.of(), "weather", null, "weatherSeed", 0, "weatherKeyframes", List.of());
    }
}
