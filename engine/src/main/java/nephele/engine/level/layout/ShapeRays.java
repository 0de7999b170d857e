package nephele.engine.level.layout;

import java.util.List;
import nephele.engine.math.Ray;
import nephele.engine.math.RayClip;
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

    /** Clips the ray by the shape's half-spaces; a shape without planes is its bounds. */
    private static double entry(FreeCells.Shape shape, Ray ray) {
        double within = ray.boxEntry(shape.bounds(), Double.POSITIVE_INFINITY);
        RayClip clip = new RayClip(ray, within, Double.POSITIVE_INFINITY);
        shape.planes().forEach(clip::keepBehind);
        return clip.enter() <= clip.leave() ? clip.enter() : Double.POSITIVE_INFINITY;
    }
}
