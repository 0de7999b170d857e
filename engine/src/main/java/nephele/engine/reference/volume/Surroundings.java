package nephele.engine.reference.volume;

import java.util.List;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/** The surroundings of media: light that comes from outside, and walls that stop it. May belong to one thread. */
public interface Surroundings {
    /** Returns sun and moon, as far as they give light. */
    List<DistantLight> lights();

    /**
     * Returns the RGB radiance that a path receives which leaves the media and meets no wall.
     *
     * @param from the last place of the path
     * @param direction of the path there, unit
     */
    Vec3 skylight(Vec3 from, Vec3 direction);

    /** Returns how far a ray of unit direction can meet media; infinite but for a planet in its way. */
    double reachMetres(Ray ray);

    /** Returns true if a wall casts the shadow of a light on the origin of a ray towards it. */
    boolean isLightBlocked(Ray ray);

    /**
     * Returns true if a wall ends a path.
     *
     * @param ray of unit direction
     * @param toMetres may be infinite
     */
    boolean isPathBlocked(Ray ray, double toMetres);
}
