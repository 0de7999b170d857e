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

    private Daylight() {}

    /**
     * Returns the environment at an instant: its atmosphere has the day and the hour, and its sun stands where the hour
     * puts it unless another direction is written. Without an atmosphere a sun without a direction does not shine, which
     * {@code check} reports. Itself if nothing differs.
     *
     * @param environment as written, or at the simulated time 0
     * @param seconds simulated time
     */
    public static Environment at(Environment environment, double seconds) {
        if (!(environment.sky() instanceof Atmosphere sky)) {
            boolean isSomewhere = environment.sun() == null || environment.sun().directionTowardsSun() != null;
            return isSomewhere ? environment : environment.with((Sun) null);
        }
        Atmosphere then = CelestialPositions.later(sky, seconds);
        Environment later = then.equals(sky) ? environment : environment.with(then);
        if (!followsHour(environment.sun(), sky)) {
            return later;
        }
        Sun sun = ofHour(environment.sun(), then);
        return sun.equals(environment.sun()) ? later : later.with(sun);
    }

    /**
     * Returns true if the hour has the direction of a sun: none is written, or the one that the hour has already given,
     * which no written one equals to the last digit.
     */
    private static boolean followsHour(Sun sun, Atmosphere sky) {
        return sun == null
                || sun.directionTowardsSun() == null
                || sun.directionTowardsSun().equals(CelestialPositions.towardsSun(sky));
    }

    private static Sun ofHour(Sun before, Atmosphere then) {
        Vec3 towards = CelestialPositions.towardsSun(then);
        return before == null
                ? new Sun(towards, SOLAR_IRRADIANCE, true)
                : new Sun(towards, before.irradiance(), before.castsShadow());
    }

    /** Returns the level at the simulated time 0, with the sun of its hour. */
    public static Level lit(Level level) {
        return lit(level, 0);
    }

    /** Returns the level with the environment of a simulated time. */
    public static Level lit(Level level, double seconds) {
        Environment lit = at(level.environment(), seconds);
        return lit == level.environment() ? level : level.with(lit, level.lights());
    }

    /** Returns true if the sky, and a sun without a written direction, follow the simulated time. */
    public static boolean moves(Environment environment) {
        return environment.sky() instanceof Atmosphere sky && sky.dayLengthSeconds() > 0;
    }

    /** Returns the sine of the sun's elevation some simulated seconds after an instant. */
    public static double sunSineAfter(Environment now, double seconds) {
        return Directions.unit(at(now, seconds).sun().directionTowardsSun()).y();
    }

    /** Returns the air of a sky, under its sun. */
    public static Air air(Atmosphere sky) {
        double albedo = sky.groundAlbedo();
        double sun = Math.toRadians(sky.sunRadiusDegrees());
        return new Air(new Vec3(albedo, albedo, albedo), sky.mieScale(), sky.mieG(), sky.ozoneScale(), sun);
    }

    /**
     * Returns the sun as it shines on the surfaces of a level: dimmed by the air above y = 0, and by as much of its disc
     * as the horizon hides. At night the moon is in its place. Itself without an atmosphere; {@code null} without a sun.
     */
    public static Sun onGround(Environment environment) {
        return atHeight(environment, 0);
    }

    /** Returns the sun as it shines at a height, which is above the ground's horizon when that is already in shade. */
    public static Sun atHeight(Environment environment, double metres) {
        double height = Math.max(0, metres);
        double dip = Math.acos(Air.PLANET_RADIUS_METRES / (Air.PLANET_RADIUS_METRES + height));
        double lowest = -Math.sin(dip);
        Sun sun = environment.sun();
        if (sun == null || !(environment.sky() instanceof Sky.Atmosphere sky)) {
            return sun;
        }
        Moonlight moon = Moonlight.of(sky, sun);
        if (moon.shines()) {
            Vec3 through = air(sky).transmittance(
                            height, Math.max(lowest, moon.towardsMoon().y()));
            return new Sun(
                    moon.towardsMoon(),
                    sun.irradiance().times(moon.irradiance()).times(through),
                    sun.castsShadow());
        }
        double sine = Directions.unit(sun.directionTowardsSun()).y();
        Vec3 arrives = sun.irradiance().times(air(sky).sunlight(height, sine));
        return new Sun(sun.directionTowardsSun(), arrives, sun.castsShadow());
    }
}
