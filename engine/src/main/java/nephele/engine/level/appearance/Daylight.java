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

    private static final double OBLIQUITY_DEGREES = 23.44;
    private static final double DAYS_IN_YEAR = 365.25;
    /** Day of the year at which the sun's declination grows through zero. */
    private static final double EQUINOX_DAY = 80;
    /** A moving sun stands still for this part of a turn, so that nothing is drawn anew for less than a pixel. */
    private static final double STEP_OF_DAY = 1.0 / 36_000;

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
        double days = sky.dayLengthSeconds() > 0 ? seconds / sky.dayLengthSeconds() : 0;
        double stepped = Math.floor(days / STEP_OF_DAY) * STEP_OF_DAY;
        return new Environment(
                new Sun(towardsSun(sky, stepped), SOLAR_IRRADIANCE, true),
                sky,
                environment.ambient(),
                environment.exposureStops(),
                environment.toneCurve(),
                environment.fog(),
                environment.clouds());
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

    /**
     * Returns the direction towards the sun, unit. Its declination is that of P. I. Cooper, "The absorption of radiation
     * in solar stills", 1969, equation 1, for a circular orbit.
     *
     * @param days after the written hour
     */
    static Vec3 towardsSun(Atmosphere sky, double days) {
        double day = sky.dayOfYear() + sky.timeOfDayHours() / 24 + days;
        double declination =
                Math.toRadians(OBLIQUITY_DEGREES) * Math.sin(2 * Math.PI * (day - EQUINOX_DAY) / DAYS_IN_YEAR);
        double hour = 2 * Math.PI * ((sky.timeOfDayHours() / 24 + days) % 1 - 0.5);
        double latitude = Math.toRadians(sky.latitudeDegrees());
        double up = Math.sin(latitude) * Math.sin(declination)
                + Math.cos(latitude) * Math.cos(declination) * Math.cos(hour);
        double north = Math.cos(latitude) * Math.sin(declination)
                - Math.sin(latitude) * Math.cos(declination) * Math.cos(hour);
        double east = -Math.cos(declination) * Math.sin(hour);
        return Directions.unit(new Vec3(east, up, -north));
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
    static double shareAboveHorizon(double elevationRadians) {
        double d = Math.max(-1, Math.min(1, elevationRadians / SUN_RADIUS_RADIANS));
        return 0.5 + (d * Math.sqrt(1 - d * d) + Math.asin(d)) / Math.PI;
    }
}
