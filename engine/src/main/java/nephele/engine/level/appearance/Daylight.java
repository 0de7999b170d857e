package nephele.engine.level.appearance;

import nephele.engine.atmosphere.Air;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.Sky.Atmosphere;
import nephele.engine.level.Sun;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/** The sun of an environment whose sky is an atmosphere: where it stands at an hour, what of it reaches the ground. */
public final class Daylight {
    /** Outside the air, for a level that has no sun of its own. */
    private static final Vec3 SOLAR_IRRADIANCE = new Vec3(4, 4, 4);

    public static final double SUN_RADIUS_RADIANS = Math.toRadians(0.2666);

    private Daylight() {}

    /**
     * Returns the environment with the sun of its hour; itself if it has a sun of its own, or no atmosphere.
     *
     * @param seconds simulated time
     */
    public static Environment at(Environment environment, double seconds) {
        if (environment.sun() != null || !(environment.sky() instanceof Atmosphere sky)) {
            return environment;
        }
        double days = Heavens.days(sky, seconds);
        return environment.with(new Sun(Heavens.towardsSun(sky, days), SOLAR_IRRADIANCE, true));
    }

    /** Returns the level with the sun of its hour; itself if that is written, or there is no atmosphere. */
    public static Level lit(Level level) {
        Environment lit = at(level.environment(), 0);
        return lit == level.environment() ? level : level.with(lit, level.lights());
    }

    /** Returns true if the sun follows the simulated time. */
    public static boolean moves(Environment environment) {
        return environment.sun() == null && environment.sky() instanceof Atmosphere sky && sky.dayLengthSeconds() > 0;
    }

    /** Returns the air of a sky. */
    public static Air air(Atmosphere sky) {
        double albedo = sky.groundAlbedo();
        return new Air(new Vec3(albedo, albedo, albedo), sky.mieScale(), sky.mieG(), sky.ozoneScale());
    }

    /**
     * Returns the sun as it shines on the surfaces of a level: dimmed by the air above y = 0, and by as much of its disc
     * as the horizon hides. Itself without an atmosphere; {@code null} without a sun.
     */
    public static Sun onGround(Environment environment) {
        Sun sun = environment.sun();
        if (sun == null || !(environment.sky() instanceof Sky.Atmosphere sky)) {
            return sun;
        }
        double sine = Directions.unit(sun.directionTowardsSun()).y();
        Vec3 dimmed = air(sky).transmittance(0, Math.max(0, sine));
        double seen = shareAboveHorizon(Math.asin(sine));
        Vec3 outside = sun.irradiance();
        return new Sun(
                sun.directionTowardsSun(),
                new Vec3(
                        seen * dimmed.x() * outside.x(),
                        seen * dimmed.y() * outside.y(),
                        seen * dimmed.z() * outside.z()),
                sun.castsShadow());
    }

    /** Returns the share of the sun's disc above the horizon. */
    public static double shareAboveHorizon(double elevationRadians) {
        double d = Math.max(-1, Math.min(1, elevationRadians / SUN_RADIUS_RADIANS));
        return 0.5 + (d * Math.sqrt(1 - d * d) + Math.asin(d)) / Math.PI;
    }
}
