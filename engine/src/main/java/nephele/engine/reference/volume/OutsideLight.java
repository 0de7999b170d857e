package nephele.engine.reference.volume;

import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/**
 * The light around media in empty space: a sun without a visible disc, and a sky of one radiance in all directions.
 *
 * @param towardsSun unit length
 * @param irradiance of the sun, RGB, on a plane perpendicular to its beam
 * @param skyRadiance RGB
 */
public record OutsideLight(Vec3 towardsSun, Vec3 irradiance, Vec3 skyRadiance) implements Surroundings {
    /** Makes the direction a unit vector. */
    public OutsideLight {
        towardsSun = Directions.unit(towardsSun);
        if (towardsSun == null) {
            throw new IllegalArgumentException("the direction towards the sun has no length");
        }
    }

    /** Returns sky light alone. */
    public static OutsideLight sky(Vec3 radiance) {
        return new OutsideLight(new Vec3(0, 1, 0), Vec3.ZERO, radiance);
    }

    @Override
    public Vec3 sunlight(Vec3 place) {
        return irradiance;
    }

    @Override
    public Vec3 skylight(Vec3 from, Vec3 direction) {
        return skyRadiance;
    }

    @Override
    public boolean isSunBlocked(Ray ray) {
        return false;
    }

    @Override
    public boolean isPathBlocked(Ray ray, double toMetres) {
        return false;
    }
}
