package nephele.lab.bake;

import java.util.Optional;
import nephele.engine.atmosphere.Air;
import nephele.engine.atmosphere.SkyTable;
import nephele.engine.atmosphere.SunOverLimb;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/**
 * The sun's disc over an atmosphere as an eye sees it, with the limb darkening of {@code atmosphere.frag}: Eddington's
 * law, with the mean of the disc 1. Traced pictures are without it.
 *
 * @param middle unit
 * @param radiance the mean of the disc outside the air
 */
record SunDisc(Vec3 middle, Vec3 radiance, Air air, double eyeHeight) {
    /** Returns the disc of an hour; empty if all of it is below the eye's horizon. */
    static Optional<SunDisc> of(Sky.Atmosphere sky, Sun sun, Vec3 eye) {
        Vec3 towardsSun = Directions.unit(sun.directionTowardsSun());
        double height = Math.max(0, eye.y());
        double above = Math.asin(towardsSun.y()) + SunOverLimb.RADIUS_RADIANS;
        double radius = SunOverLimb.RADIUS_RADIANS;
        return above > SkyTable.horizonRadians(height)
                ? Optional.of(new SunDisc(
                        towardsSun,
                        sun.irradiance().scaled(1 / (Math.PI * radius * radius)),
                        Daylight.air(sky),
                        height))
                : Optional.empty();
    }

    /** Returns the disc's radiance in a unit direction, zero beside it and below the horizon. */
    Vec3 towards(Vec3 direction) {
        double fromMiddle = direction.minus(middle).length() / SunOverLimb.RADIUS_RADIANS;
        if (fromMiddle >= 1 || Math.asin(direction.y()) < SkyTable.horizonRadians(eyeHeight)) {
            return Vec3.ZERO;
        }
        Vec3 through = air.transmittance(eyeHeight, direction.y());
        double limb = 0.5 + 0.75 * Math.sqrt(1 - fromMiddle * fromMiddle);
        return new Vec3(
                radiance.x() * through.x() * limb,
                radiance.y() * through.y() * limb,
                radiance.z() * through.z() * limb);
    }
}
