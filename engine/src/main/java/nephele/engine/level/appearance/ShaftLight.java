package nephele.engine.level.appearance;

import nephele.engine.level.Cloud;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.math.Vec3;

/**
 * The light of which clouds cast shadows into the air: the sun, at night the moon. Clouds with {@code shafts} shade what the
 * air scatters of it once; light that is scattered more often comes from all sides and stays.
 *
 * @param towards unit
 * @param irradiance outside the air
 * @param strength 0 to 1: shafts fade out while the light sets, since a grazing shadow has no end
 */
public record ShaftLight(Vec3 towards, Vec3 irradiance, double strength) {
    /** Sines of the elevations, 0.5 and 3 degrees, between which shafts fade. */
    private static final double NONE_SINE = 0.0087;

    private static final double FULL_SINE = 0.0523;

    /** Returns true if the air of an environment has shafts. */
    public static boolean isIn(Environment environment) {
        return environment.sky() instanceof Sky.Atmosphere
                && environment.sun() != null
                && WeatherClouds.all(environment).stream().anyMatch(Cloud::shafts);
    }

    /** Returns the light of an instant. */
    public static ShaftLight of(SunAndMoon lights) {
        Moonlight moon = lights.moonlight();
        return moon.shines()
                ? of(moon.towardsMoon(), lights.moonIrradiance())
                : of(lights.towardsSun(), lights.environment().sun().irradiance());
    }

    private static ShaftLight of(Vec3 towards, Vec3 irradiance) {
        double t = Math.max(0, Math.min(1, (towards.y() - NONE_SINE) / (FULL_SINE - NONE_SINE)));
        return new ShaftLight(towards, irradiance, t * t * (3 - 2 * t));
    }
}
