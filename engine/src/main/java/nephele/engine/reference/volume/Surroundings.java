package nephele.engine.reference.volume;

import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/** The surroundings of media: light that comes from outside, and walls that stop it. May belong to one thread. */
public interface Surroundings {
    /** Returns the unit direction towards the sun; any direction if there is none. */
    Vec3 towardsSun();

    /**
     * Returns the sun's RGB irradiance at a place, on a plane perpendicular to its beam, before media and walls dim it;
     * zero without a sun.
     */
    Vec3 sunlight(Vec3 place);

    /**
     * Returns the RGB radiance that a path receives which leaves the media and meets no wall.
     *
     * @param from the last place of the path
     * @param direction of the path there, unit
     */
    Vec3 skylight(Vec3 from, Vec3 direction);

    /** Returns how far a ray of unit direction can meet media; infinite but for a planet in its way. */
    double reachMetres(Ray ray);

    /** Returns true if a wall casts the sun's shadow on the origin of a ray towards the sun. */
    boolean isSunBlocked(Ray ray);

    /**
     * Returns true if a wall ends a path.
     *
     * @param ray of unit direction
     * @param toMetres may be infinite
     */
    boolean isPathBlocked(Ray ray, double toMetres);
}
