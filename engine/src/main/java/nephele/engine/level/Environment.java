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
 * @param exposureStops exposure = 2^stops
 * @param fog {@code null} for none
 * @param weather clouds that the engine adds to the written ones; {@code null} for none
 */
public record Environment(
        @Written Sun sun,
        @Written Sky sky,
        @Written(min = 0, max = 1e9) Vec3 ambient,
        @Written(min = -32, max = 32) double exposureStops,
        @Written(absent = "\"clip\"") ToneCurve toneCurve,
        @Written Fog fog,
        @Written(most = 1000) List<Cloud> clouds,
        @Written Weather weather,
        @Written(min = -9.007199254740991e15, max = 9.007199254740991e15) long weatherSeed) {

    /** Creates an environment without weather. */
    public Environment(
            Sun sun, Sky sky, Vec3 ambient, double exposureStops, ToneCurve toneCurve, Fog fog, List<Cloud> clouds) {
        this(sun, sky, ambient, exposureStops, toneCurve, fog, clouds, null, 0);
    }
}
