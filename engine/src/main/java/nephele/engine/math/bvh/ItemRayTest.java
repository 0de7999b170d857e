package nephele.engine.math.bvh;

import nephele.engine.math.Ray;

/** The caller's exact test of an item of a {@link SpatialIndex} against a ray. */
@FunctionalInterface
public interface ItemRayTest {
    /**
     * Intersects an item with a ray.
     *
     * @param limit hits beyond it may be reported as infinity
     * @return ray parameter of the first hit, at least 0; {@link Double#POSITIVE_INFINITY} for a miss
     */
    double hit(Ray ray, int item, double limit);
}
