package nephele.engine.cloud.field;

import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;

/**
 * A part of a ray between two ray parameters in metres. It is empty unless {@code fromMetres} is less than {@code
 * toMetres}.
 */
record RaySpan(double fromMetres, double toMetres) {
    static final RaySpan EMPTY = new RaySpan(0, 0);

    /** Returns the part of a span of a ray that is in a box, which may be infinite. */
    static RaySpan inBox(Ray ray, Aabb box, double fromMetres, double toMetres) {
        if (!ray.isCastable()) {
            return EMPTY;
        }
        return new RaySpan(fromMetres, toMetres)
                .between(ray.originX(), ray.directionX(), box.minX(), box.maxX())
                .between(ray.originY(), ray.directionY(), box.minY(), box.maxY())
                .between(ray.originZ(), ray.directionZ(), box.minZ(), box.maxZ());
    }

    boolean isEmpty() {
        return !(fromMetres < toMetres);
    }

    private RaySpan between(double origin, double direction, double min, double max) {
        if (direction == 0) {
            return origin >= min && origin <= max ? this : EMPTY;
        }
        double first = ((direction > 0 ? min : max) - origin) / direction;
        double last = ((direction > 0 ? max : min) - origin) / direction;
        return new RaySpan(Math.max(fromMetres, first), Math.min(toMetres, last));
    }
}
