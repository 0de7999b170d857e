package nephele.engine.level.appearance;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.Function;
import nephele.engine.asset.Picture;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.ClearSky;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/** The radiance of a sky in every direction. */
@FunctionalInterface
public interface SkyRadiance {
    /**
     * Returns linear RGB for a unit direction, y up.
     *
     * @param eyeHeight y of the place that sees it; an atmosphere looks different from a height
     */
    Vector3d from(double eyeHeight, double x, double y, double z);

    /** Returns what a place at y = 0 sees. */
    default Vector3d from(double x, double y, double z) {
        return from(0, x, y, z);
    }

    /**
     * Returns the radiance of the sky of an environment.
     *
     * @param environment with the sun of its hour
     * @param pictureOf decodes an asset; called for skyboxes only
     * @return empty without a sky
     */
    static Optional<SkyRadiance> of(
            Environment environment, Function<String, Picture> pictureOf, ColourDecoding decoding) {
        return environment.sky() instanceof Sky.Atmosphere atmosphere
                ? Optional.ofNullable(environment.sun()).map(sun -> of(atmosphere, sun))
                : of(environment.sky(), pictureOf, decoding);
    }

    /** Returns the radiance of a sky without a sun; empty for none, and for an atmosphere, which is then dark. */
    static Optional<SkyRadiance> of(Sky sky, Function<String, Picture> pictureOf, ColourDecoding decoding) {
        if (sky instanceof Sky.Constant constant) {
            return Optional.of((height, x, y, z) -> constant.radiance().toVector());
        } else if (sky instanceof Sky.Gradient gradient) {
            return Optional.of(of(gradient));
        } else if (sky instanceof Sky.Skybox box) {
            return Optional.of(of(box, SkyboxPictures.of(box, pictureOf), decoding));
        }
        return Optional.empty();
    }

    private static SkyRadiance of(Sky.Skybox box, SkyboxPictures pictures, ColourDecoding decoding) {
        double[] linear = Arrays.stream(decoding.table())
                .map(value -> box.whiteRadiance() * value)
                .toArray();
        return (height, x, y, z) -> pictures.radiance(linear, x, y, z);
    }

    /** By numerical integration, which takes some 0.1 ms for a direction. */
    private static SkyRadiance of(Sky.Atmosphere atmosphere, Sun sun) {
        AirTables tables = AirCache.tables(Daylight.air(atmosphere));
        Vec3 towardsSun = Directions.unit(sun.directionTowardsSun());
        Moonlight moon = Moonlight.of(atmosphere, sun);
        return (height, x, y, z) -> {
            ClearSky sky = new ClearSky(tables);
            Vec3 direction = new Vec3(x, y, z);
            Vector3d sum = sky.radiance(height, direction, towardsSun)
                    .plus(CelestialPositions.nightGlow(atmosphere, towardsSun.y(), y))
                    .toVector();
            if (moon.shines()) {
                Vector3d moonlit =
                        sky.radiance(height, direction, moon.towardsMoon()).toVector();
                sum.add(moonlit.mul(moon.irradiance().toVector()));
            }
            return sum.mul(sun.irradiance().toVector());
        };
    }

    private static SkyRadiance of(Sky.Gradient gradient) {
        return (height, x, y, z) -> {
            Vec3 end = y < 0 ? gradient.ground() : gradient.zenith();
            return gradient.horizon().toVector().lerp(end.toVector(), Math.min(Math.abs(y), 1));
        };
    }
}
