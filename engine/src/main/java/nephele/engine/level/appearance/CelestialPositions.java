package nephele.engine.level.appearance;

import nephele.engine.level.Sky.Atmosphere;
import nephele.engine.math.Vec3;

/**
 * Where sun, moon and stars stand at an hour. North is −z, east is +x. Circular orbits: the sun keeps true solar time,
 * and the moon goes round once in a synodic month, new on the sixth day of the year.
 */
public final class CelestialPositions {
    private static final double OBLIQUITY_RADIANS = Math.toRadians(23.44);
    private static final double DAYS_IN_YEAR = 365.25;
    private static final double DAYS_IN_MONTH = 29.530588;
    private static final double NEW_MOON_DAY = 6;
    /** Day of the year at which the sun's declination grows through zero. */
    private static final double EQUINOX_DAY = 80;
    /** A moving sky stands still for this part of a turn, so that nothing is drawn anew for less than a pixel. */
    private static final double STEP_OF_DAY = 1.0 / 36_000;
    /** Keeps a time at which a step begins in it. */
    private static final double ROUNDING = 1e-6;

    private static final Vec3 NIGHT_GLOW = new Vec3(0.55, 0.75, 1.25).scaled(6.4e-6);

    /** The glow's irradiance of a level ground, divided by π and by the glow of the zenith. */
    private static final double GLOW_ON_GROUND = 1.061;

    private CelestialPositions() {}

    /** Returns the days that have passed since the written hour, in steps of a hundredth of a degree of the sun. */
    static double days(Atmosphere sky, double seconds) {
        double days = sky.dayLengthSeconds() > 0 ? seconds / sky.dayLengthSeconds() : 0;
        return Math.floor(days / STEP_OF_DAY + ROUNDING) * STEP_OF_DAY;
    }

    /**
     * Returns the sky with the day and the hour of a simulated time. Days are counted on beyond the end of a year, since
     * the moon does not begin anew with it.
     *
     * @param sky at the simulated time 0
     */
    static Atmosphere later(Atmosphere sky, double seconds) {
        double passed = days(sky, seconds);
        if (passed == 0) {
            return sky;
        }
        double days = sky.timeOfDayHours() / 24 + passed;
        double whole = Math.floor(days);
        return new Atmosphere(
                sky.groundAlbedo(),
                sky.mieScale(),
                sky.mieG(),
                sky.ozoneScale(),
                sky.latitudeDegrees(),
                sky.dayOfYear() + whole,
                24 * (days - whole),
                sky.dayLengthSeconds(),
                sky.sunRadiusDegrees());
    }

    private static double day(Atmosphere sky) {
        return sky.dayOfYear() + sky.timeOfDayHours() / 24;
    }

    /** Returns the angle of the sun from the meridian, radians, positive after noon. */
    private static double hourAngle(Atmosphere sky) {
        return 2 * Math.PI * (sky.timeOfDayHours() / 24 - 0.5);
    }

    /**
     * Returns the light of the night's own air and of unresolved stars, per unit irradiance of the sun; the twin of the
     * glow in {@code atmosphere.frag}. The planet's ground reflects it.
     *
     * @param sunSine of the sun's elevation
     * @param sine of the elevation of the direction
     */
    public static Vec3 nightGlow(Atmosphere sky, double sunSine, double sine) {
        double t = Math.max(0, Math.min(1, (sunSine + 0.21) / 0.105));
        double afterDusk = 1 - t * t * (3 - 2 * t);
        double shape = sine < 0 ? sky.groundAlbedo() * GLOW_ON_GROUND : 1 + 0.8 * Math.exp(-5 * sine);
        return NIGHT_GLOW.scaled(afterDusk * shape);
    }

    /** Returns the unit direction towards the sun. */
    static Vec3 towardsSun(Atmosphere sky) {
        double longitude = 2 * Math.PI * (day(sky) - EQUINOX_DAY) / DAYS_IN_YEAR;
        return horizontal(sky, declination(longitude), hourAngle(sky));
    }

    /** Returns the unit direction towards the moon. */
    public static Vec3 towardsMoon(Atmosphere sky) {
        double fromSun = 2 * Math.PI * (day(sky) - NEW_MOON_DAY) / DAYS_IN_MONTH;
        double longitude = 2 * Math.PI * (day(sky) - EQUINOX_DAY) / DAYS_IN_YEAR + fromSun;
        return horizontal(sky, declination(longitude), hourAngle(sky) - fromSun);
    }

    /** Returns the axes of the stars in the world: towards the equinox, 90 degrees east of it, and the north pole. */
    public static Vec3[] celestialAxes(Atmosphere sky) {
        double longitude = 2 * Math.PI * (day(sky) - EQUINOX_DAY) / DAYS_IN_YEAR;
        double equinox = hourAngle(sky) + longitude;
        return new Vec3[] {
            horizontal(sky, 0, equinox), horizontal(sky, 0, equinox - Math.PI / 2), horizontal(sky, Math.PI / 2, 0)
        };
    }

    private static double declination(double longitude) {
        return Math.asin(Math.sin(OBLIQUITY_RADIANS) * Math.sin(longitude));
    }

    /** J. Meeus, "Astronomical Algorithms", second edition, 1998, equations 13.5 and 13.6, as a direction. */
    private static Vec3 horizontal(Atmosphere sky, double declination, double hourAngle) {
        double latitude = Math.toRadians(sky.latitudeDegrees());
        double up = Math.sin(latitude) * Math.sin(declination)
                + Math.cos(latitude) * Math.cos(declination) * Math.cos(hourAngle);
        double north = Math.cos(latitude) * Math.sin(declination)
                - Math.sin(latitude) * Math.cos(declination) * Math.cos(hourAngle);
        double east = -Math.cos(declination) * Math.sin(hourAngle);
        return new Vec3(east, up, -north);
    }
}
