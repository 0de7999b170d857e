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
 */
public record Environment(
        @Written Sun sun,
        @Written Sky sky,
        @Written(min = 0, max = 1e9) Vec3 ambient,
        @Written(min = -32, max = 32) double exposureStops,
        @Written(absent = "\"clip\"") ToneCurve toneCurve,
        @Written Fog fog,
        @Written(most = 1000) List<Cloud> clouds) {
    public Environment with(Sun newSun) {
        return new Environment(newSun, sky, ambient, exposureStops, toneCurve, fog, clouds);
    }

    public Environment with(Sky newSky) {
        return new Environment(sun, newSky, ambient, exposureStops, toneCurve, fog, clouds);
    }
}
