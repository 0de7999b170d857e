package nephele.engine.reference.sky;

import java.util.Optional;
import nephele.engine.atmosphere.Air;
import nephele.engine.atmosphere.SkyTable;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/**
 * The sun's disc over an atmosphere, dimmed by the air before each of its points, with the limb darkening of {@code
 * atmosphere.frag}: Eddington's law, with the mean of the disc 1.
 *
 * @param middle unit
 * @param radiance the mean of the disc outside the air
 */
public record SunDisc(Vec3 middle, Vec3 radiance, Air air) {
    /** Returns the disc of an environment; empty without an atmosphere or a sun, and for a sun that is a point. */
    public static Optional<SunDisc> of(Environment environment) {
        if (!(environment.sky() instanceof Sky.Atmosphere sky) || environment.sun() == null) {
            return Optional.empty();
        }
        Air air = Daylight.air(sky);
        double radius = air.sunRadiusRadians();
        Vec3 middle = Directions.unit(environment.sun().directionTowardsSun());
        Vec3 outside = environment.sun().irradiance();
        return radius == 0
                ? Optional.empty()
                : Optional.of(new SunDisc(middle, outside.scaled(1 / (Math.PI * radius * radius)), air));
    }

    /** Returns the angular radius. */
    public double radiusRadians() {
        return air.sunRadiusRadians();
    }

    /**
     * Returns the disc's radiance in a unit direction, black beside it and below the horizon.
     *
     * @param eyeHeight y of the eye
     */
    public Vec3 towards(Vec3 direction, double eyeHeight) {
        double height = Math.max(0, Math.min(Air.TOP_METRES, eyeHeight));
        double fromMiddle = direction.minus(middle).length() / radiusRadians();
        if (fromMiddle >= 1 || StrictMath.asin(direction.y()) < SkyTable.horizonRadians(height)) {
            return Vec3.ZERO;
        }
        double limb = 0.5 + 0.75 * Math.sqrt(1 - fromMiddle * fromMiddle);
        return radiance.times(air.transmittance(height, direction.y())).scaled(limb);
    }
}
