package nephele.engine.cloud;

import java.util.OptionalDouble;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;

/**
 * The extinction of a medium at each point. Immutable, so that threads can share it.
 *
 * <p>Rays have directions of unit length: their parameters are metres.
 */
public interface ExtinctionField {
    /** Returns the extinction per metre at a point in world metres; at least 0 and finite, 0 outside the bounds. */
    double perMetre(double x, double y, double z);

    /** Returns a box that contains all of the medium; infinite in x and z for a layer, empty if there is none. */
    Aabb bounds();

    /** Returns true if there is surely no extinction anywhere. */
    default boolean isEmpty() {
        return bounds().isEmpty();
    }

    /**
     * Walks along a part of a ray through segments with upper bounds of the extinction. Parts of the ray that no
     * segment covers have no extinction.
     *
     * @param ray of unit direction
     * @param toMetres may be infinite
     */
    MajorantWalk walk(Ray ray, double fromMetres, double toMetres);

    /**
     * Returns the optical depth of a part of a ray if this field has a closed form for it.
     *
     * @param ray of unit direction
     * @param toMetres may be infinite
     */
    default OptionalDouble closedDepth(Ray ray, double fromMetres, double toMetres) {
        return OptionalDouble.empty();
    }
}
