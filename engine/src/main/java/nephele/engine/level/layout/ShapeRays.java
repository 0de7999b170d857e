package nephele.engine.level.layout;

import java.util.List;
import nephele.engine.math.Plane;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.SpatialIndex;

/** Rays among the shapes of a search for leaks. */
final class ShapeRays {
    private final List<FreeCells.Shape> shapes;
    private final SpatialIndex index;

    ShapeRays(List<FreeCells.Shape> shapes) {
        this.shapes = shapes;
        index = SpatialIndex.of(shapes.stream().map(FreeCells.Shape::bounds).toList());
    }

    /** Returns true if a ray meets a shape at any distance. */
    boolean meets(Vec3 from, Vec3 direction) {
        return index.anyHit(
                Ray.of(from, direction), Double.POSITIVE_INFINITY, (ray, item, limit) -> entry(shapes.get(item), ray));
    }

    /** Clips the ray by the shape's half-spaces (Cyrus and Beck 1978); a shape without planes is its bounds. */
    private static double entry(FreeCells.Shape shape, Ray ray) {
        double enter = ray.boxEntry(shape.bounds(), Double.POSITIVE_INFINITY);
        double leave = Double.POSITIVE_INFINITY;
        for (Plane plane : shape.planes()) {
            double rate = plane.nx() * ray.directionX() + plane.ny() * ray.directionY() + plane.nz() * ray.directionZ();
            double front = plane.signedDistance(ray.originX(), ray.originY(), ray.originZ());
            if (rate < 0) {
                enter = Math.max(enter, -front / rate);
            } else if (rate > 0) {
                leave = Math.min(leave, -front / rate);
            } else if (front > 0) {
                return Double.POSITIVE_INFINITY;
            }
        }
        return enter <= leave ? enter : Double.POSITIVE_INFINITY;
    }
}
