package nephele.engine.level.appearance;

import nephele.engine.level.Environment;
import nephele.engine.level.Sky.Atmosphere;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/**
 * The lights of an atmosphere at an instant.
 *
 * @param environment with an atmosphere and the sun of its hour
 * @param towardsSun unit
 */
public record SunAndMoon(Environment environment, Vec3 towardsSun, Moonlight moonlight) {
    /** Returns the lights of an environment with an atmosphere and a sun. */
    public static SunAndMoon of(Environment environment) {
        return new SunAndMoon(
                environment,
                Directions.unit(environment.sun().directionTowardsSun()),
                Moonlight.of((Atmosphere) environment.sky(), environment.sun()));
    }

    /** Returns true if surfaces of an environment are seen through air: under an atmosphere with a sun. */
    public static boolean lightAir(Environment environment) {
        return environment.sky() instanceof Atmosphere && environment.sun() != null;
    }

    /** Returns true if the moon lights the air of an environment, at once or, while its sky moves, at some time. */
    public static boolean moonLightsAir(Environment environment) {
        return lightAir(environment)
                && (Daylight.moves(environment)
                        || of(Daylight.at(environment, 0)).moonlight.shines());
    }

    /** Returns true if an environment has the same sky and sun objects. */
    public boolean areOf(Environment other) {
        return other.sky() == environment.sky() && other.sun() == environment.sun();
    }

    /** Returns true if they follow the simulated time. */
    public boolean move() {
        return Daylight.moves(environment);
    }

    /** Returns the sine of the sun's elevation some simulated seconds later. */
    public double sunSineAfter(double seconds) {
        return Daylight.sunSineAfter(environment, seconds);
    }

    /** Returns the sine of the moon's elevation some simulated seconds later. */
    public double moonSineAfter(double seconds) {
        return Moonlight.sineAfter((Atmosphere) environment.sky(), seconds);
    }

    /** Returns true if the moon will give light some simulated seconds later. */
    public boolean moonShinesAfter(double seconds) {
        return of(Daylight.at(environment, seconds)).moonlight.shines();
    }

    /** Returns the irradiance of the moon outside the air; zero while the moon does not count. */
    public Vec3 moonIrradiance() {
        return environment.sun().irradiance().times(moonlight.irradiance());
    }
}
