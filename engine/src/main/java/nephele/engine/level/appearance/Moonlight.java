package nephele.engine.level.appearance;

import nephele.engine.atmosphere.SunOverLimb;
import nephele.engine.level.Sky.Atmosphere;
import nephele.engine.level.Sun;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/**
 * The sunlight that the moon sends to the planet, outside the air. It fades in between 4 and 12 degrees of the sun below
 * the horizon, where the sun itself does not shine any more, so that one directional light serves both. As all light of
 * the night it is brighter than in nature.
 *
 * @param towardsMoon unit
 * @param irradiance per unit irradiance of the sun; zero while the moon does not count
 */
public record Moonlight(Vec3 towardsMoon, Vec3 irradiance) {
    /** The night is brighter than in nature by this factor, as in {@code atmosphere.frag}. */
    public static final double NIGHT_GAIN = 400;

    private static final double RADIUS_SINE = 0.0045;
    private static final double ALBEDO = 0.12;
    private static final Vec3 COLOUR = new Vec3(1, 0.97, 0.92);
    private static final double FULL_SINE = -0.21;
    private static final double NONE_SINE = -0.07;

    /** Returns the moonlight of an hour. */
    public static Moonlight of(Atmosphere sky, Sun sun) {
        Vec3 towardsMoon = CelestialPositions.towardsMoon(sky);
        Vec3 towardsSun = Directions.unit(sun.directionTowardsSun());
        double fraction =
                fade(towardsSun.y()) * SunOverLimb.of(0, towardsMoon.y()).fraction();
        double full = NIGHT_GAIN * ALBEDO * RADIUS_SINE * RADIUS_SINE;
        return new Moonlight(towardsMoon, COLOUR.scaled(fraction * full * phase(towardsMoon.dot(towardsSun))));
    }

    /** Returns the sine of the moon's elevation some simulated seconds after an instant. */
    public static double sineAfter(Atmosphere sky, double seconds) {
        return CelestialPositions.towardsMoon(CelestialPositions.later(sky, seconds))
                .y();
    }

    private static double fade(double sunSine) {
        double t = Math.max(0, Math.min(1, (sunSine - FULL_SINE) / (NONE_SINE - FULL_SINE)));
        return 1 - t * t * (3 - 2 * t);
    }

    /**
     * Returns the share of the full moon's light. C. W. Allen, "Astrophysical Quantities", third edition, 1976, section
     * 66: 0.026 magnitudes per degree of the phase angle, and a term of the fourth degree.
     *
     * @param cosine of the angle between moon and sun
     */
    static double phase(double cosine) {
        double degrees = Math.toDegrees(Math.acos(Math.max(-1, Math.min(1, -cosine))));
        return Math.pow(10, -0.4 * (0.026 * degrees + 4e-9 * degrees * degrees * degrees * degrees));
    }

    /** Returns the irradiance if no horizon hid a part of the disc; zero if all of it is hidden at y = 0. */
    public Vec3 ofWholeDisc() {
        return shines()
                ? irradiance.scaled(1 / SunOverLimb.of(0, towardsMoon.y()).fraction())
                : irradiance;
    }

    /** Returns true if the moon gives light. */
    public boolean shines() {
        return irradiance.y() > 0;
    }
}
