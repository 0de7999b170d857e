package nephele.engine.level;

import java.util.List;
import nephele.engine.math.Vec3;

/**
 * Sun, sky, clouds and how the picture is developed.
 *
 * @param sun {@code null}: no sun
 * @param sky {@code null}: black
 * @param ambient constant radiance that every surface receives from all around (a surface reflects albedo × ambient)
 *     instead of sky irradiance × baked visibility; {@code null}: sky and visibility
 * @param exposureStops exposure = 2^stops
 * @param fog {@code null}: none
 */
public record Environment(
        Sun sun, Sky sky, Vec3 ambient, double exposureStops, ToneCurve toneCurve, Fog fog, List<Cloud> clouds) {}
