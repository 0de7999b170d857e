package nephele.engine.level.appearance;

import java.util.Optional;
import nephele.engine.atmosphere.AirLight;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.ClearSky;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The effect of an atmosphere's air on the view of a surface, by numerical integration. A path through openings has the
 * air of the straight line that ends as the path does and is as long: what a virtual eye sees.
 */
public final class AirOfEnvironment {
    private final AirTables tables;
    private final SunAndMoon lights;

    private AirOfEnvironment(AirTables tables, SunAndMoon lights) {
        this.tables = tables;
        this.lights = lights;
    }

    /**
     * Returns the air of an environment; empty without an atmosphere or its sun.
     *
     * @param environment with the sun of its hour
     */
    public static Optional<AirOfEnvironment> of(Environment environment) {
        return environment.sky() instanceof Sky.Atmosphere sky && environment.sun() != null
                ? Optional.of(new AirOfEnvironment(AirCache.tables(Daylight.air(sky)), SunAndMoon.of(environment)))
                : Optional.empty();
    }

    /**
     * Returns radiance seen through the air.
     *
     * @param place where it comes from
     * @param direction of the path at its end, away from the eye, unit
     * @param metres length of the path
     */
    public Vector3d over(Vector3d radiance, Vec3 place, Vector3dc direction, double metres) {
        AirLight sunlit = along(place, direction, metres, lights.towardsSun());
        Vector3d sun = lights.environment().sun().irradiance().toVector();
        radiance.mul(sunlit.transmittance().toVector())
                .add(sun.mul(sunlit.radiance().toVector()));
        if (lights.moonlight().shines()) {
            Vec3 moonlit = along(place, direction, metres, lights.moonlight().towardsMoon())
                    .radiance();
            radiance.add(lights.moonIrradiance().toVector().mul(moonlit.toVector()));
        }
        return radiance;
    }

    /** Returns the share of radiance that the air of the same path lets pass, for each channel. */
    public Vector3d transmittance(Vec3 place, Vector3dc direction, double metres) {
        return along(place, direction, metres, lights.towardsSun())
                .transmittance()
                .toVector();
    }

    /**
     * Returns what the air does to light on a straight way.
     *
     * @param from where it is seen
     * @param direction away from there, unit
     * @return radiance of sun and moon, for their irradiance
     */
    public AirLight between(Vec3 from, Vec3 direction, double metres) {
        ClearSky sky = new ClearSky(tables);
        AirLight sunlit = sky.along(from.y(), direction, lights.towardsSun(), metres);
        Vec3 radiance = sunlit.radiance().times(lights.environment().sun().irradiance());
        if (lights.moonlight().shines()) {
            Vec3 towards = lights.moonlight().towardsMoon();
            AirLight moonlit = sky.along(from.y(), direction, towards, metres);
            radiance = radiance.plus(moonlit.radiance().times(lights.moonIrradiance()));
        }
        return new AirLight(radiance, sunlit.transmittance());
    }

    private AirLight along(Vec3 place, Vector3dc direction, double metres, Vec3 towardsLight) {
        double eyeHeight = place.y() - metres * direction.y();
        return new ClearSky(tables).along(eyeHeight, Vec3.of(direction), towardsLight, metres);
    }
}
