package nephele.engine.reference.sky;

import java.util.Optional;
import nephele.engine.atmosphere.Air;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The disc of the sun in the sky of an atmosphere, dimmed by the air before each of its points and darker towards its
 * limb by Eddington's law, as in {@code atmosphere.frag}. Its irradiance is that of the sun as a direction.
 */
public final class SunDisc {
    private final Air air;
    private final Vec3 towards;
    private final double radiusSine;
    private final Vec3 radianceOutside;

    private SunDisc(Air air, Vec3 towards, Vec3 irradianceOutside) {
        this.air = air;
        this.towards = towards;
        radiusSine = StrictMath.sin(air.sunRadiusRadians());
        radianceOutside = irradianceOutside.scaled(1 / (Math.PI * radiusSine * radiusSine));
    }

    /** Returns the disc of an environment; empty without an atmosphere or a sun, and for a sun that is a point. */
    public static Optional<SunDisc> of(Environment environment) {
        if (!(environment.sky() instanceof Sky.Atmosphere sky) || environment.sun() == null) {
            return Optional.empty();
        }
        Air air = Daylight.air(sky);
        return air.sunRadiusRadians() == 0
                ? Optional.empty()
                : Optional.of(new SunDisc(
                        air,
                        Directions.unit(environment.sun().directionTowardsSun()),
                        environment.sun().irradiance()));
    }

    /**
     * Returns the disc's radiance from a place; black beside the disc and below the horizon.
     *
     * @param heightMetres y of the place
     * @param away unit direction
     */
    public Vector3d radiance(double heightMetres, Vector3dc away) {
        double height = Math.max(0, Math.min(Air.TOP_METRES, heightMetres));
        Vector3d sunwards = towards.toVector();
        double fromMiddle = new Vector3d(away).cross(sunwards).length() / radiusSine;
        double horizon = -Math.sqrt(1 - square(Air.PLANET_RADIUS_METRES / (Air.PLANET_RADIUS_METRES + height)));
        if (fromMiddle >= 1 || away.dot(sunwards) < 0 || away.y() <= horizon) {
            return new Vector3d();
        }
        double limb = 0.5 + 0.75 * Math.sqrt(1 - square(fromMiddle));
        return radianceOutside
                .times(air.transmittance(height, away.y()))
                .scaled(limb)
                .toVector();
    }

    private static double square(double x) {
        return x * x;
    }
}
