package nephele.engine.level.layout;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.math.bvh.SpatialIndex;

/** The solid shapes of a level, found by place: its solids in their order, then its convex models. */
public final class BrushIndex {
    /** Depth up to which shapes only touch. */
    public static final double TOUCHING_METRES = 1e-6;

    private final List<Brush> brushes;
    private final SpatialIndex index;

    public BrushIndex(StaticShapes statics) {
        brushes = new ArrayList<>(statics.solids());
        brushes.addAll(statics.models().solids());
        index = SpatialIndex.of(
                brushes.stream().map(brush -> brush.shape().bounds()).toList());
    }

    /** Returns the shapes. */
    public List<Brush> brushes() {
        return brushes;
    }

    /** Returns the box around all shapes. */
    public Aabb bounds() {
        return index.bounds();
    }

    /** Returns the shapes of which the bounds touch a box, in ascending order. */
    public ItemList near(Aabb box) {
        ItemList found = new ItemList();
        index.overlapping(box, found);
        found.sort();
        return found;
    }

    /** Returns the first shape that holds a point at least this deep; −1 for none. */
    public int holding(Vec3 point, double depthMetres) {
        ItemList near = near(Aabb.of(List.of(point)));
        for (int i = 0; i < near.size(); i++) {
            if (deepest(brushes.get(near.get(i)).shape(), point) <= -depthMetres) {
                return near.get(i);
            }
        }
        return -1;
    }

    private static double deepest(ConvexPolyhedron shape, Vec3 point) {
        double most = Double.NEGATIVE_INFINITY;
        for (ConvexPolyhedron.Face face : shape.faces()) {
            most = Math.max(most, face.plane().signedDistance(point));
        }
        return most;
    }

    /** Returns true if no shape reaches into a box; a shape beside one of its slanted faces may count as reaching in. */
    public boolean isFree(Aabb box) {
        ItemList near = near(box);
        for (int i = 0; i < near.size(); i++) {
            if (mayReachInto(brushes.get(near.get(i)).shape(), box)) {
                return false;
            }
        }
        return true;
    }

    private static boolean mayReachInto(ConvexPolyhedron shape, Aabb box) {
        return shape.faces().stream().noneMatch(face -> face.plane().leastDistance(box) >= -TOUCHING_METRES);
    }

    /**
     * Returns true if a segment meets a shape; grazing a face does not count.
     *
     * @param marginMetres how far the shapes are shrunk
     */
    public boolean isBlocked(Vec3 from, Vec3 to, double marginMetres) {
        return index.anyHit(
                Ray.of(from, to.minus(from)), 1, (ray, item, limit) -> entry(brushes.get(item), ray, marginMetres));
    }

    /** Clips the ray's first unit by the shape's half-spaces (Cyrus and Beck 1978). */
    private static double entry(Brush brush, Ray ray, double marginMetres) {
        double enter = 0;
        double leave = 1;
        for (ConvexPolyhedron.Face face : brush.shape().faces()) {
            Plane plane = face.plane();
            double rate = plane.nx() * ray.directionX() + plane.ny() * ray.directionY() + plane.nz() * ray.directionZ();
            double front = plane.signedDistance(ray.originX(), ray.originY(), ray.originZ()) + marginMetres;
            if (rate < 0) {
                enter = Math.max(enter, -front / rate);
            } else if (rate > 0) {
                leave = Math.min(leave, -front / rate);
            } else if (front >= 0) {
                return Double.POSITIVE_INFINITY;
            }
        }
        return enter < leave ? enter : Double.POSITIVE_INFINITY;
    }
}
