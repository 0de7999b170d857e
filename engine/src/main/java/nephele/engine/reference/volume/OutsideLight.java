package nephele.engine.reference.volume;

import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/**
 * The light around media: a sun without a visible disc, and a sky of one radiance in all directions.
 *
 * @param directionTowardsSun unit length
 * @param irradiance of the sun, RGB, on a plane perpendicular to its beam
 * @param skyRadiance RGB
 */
public record OutsideLight(Vec3 directionTowardsSun, Vec3 irradiance, Vec3 skyRadiance) {
    /** Makes the direction a unit vector. */
    public OutsideLight {
        directionTowardsSun = Directions.unit(directionTowardsSun);
        if (directionTowardsSun == null) {
            throw new IllegalArgumentException("the direction towards the sun has no length");
        }
    }

    /** Returns sky light alone. */
    public static OutsideLight sky(Vec3 radiance) {
        return new OutsideLight(new Vec3(0, 1, 0), Vec3.ZERO, radiance);
    }

    boolean hasSun() {
        return !irradiance.equals(Vec3.ZERO);
    }
}
