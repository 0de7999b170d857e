package nephele.engine.portal.placement;

import java.util.List;
import java.util.function.IntConsumer;
import nephele.engine.math.Aabb;
import nephele.engine.math.bvh.SpatialIndex;

/** Convex polygons of one plane in a spatial index. */
final class PolygonIndex {
    private final List<ConvexPolygon> shapes;
    private final SpatialIndex index;

    PolygonIndex(List<ConvexPolygon> shapes) {
        this.shapes = List.copyOf(shapes);
        index = SpatialIndex.of(shapes.stream().map(ConvexPolygon::bounds).toList());
    }

    ConvexPolygon shape(int index) {
        return shapes.get(index);
    }

    int size() {
        return shapes.size();
    }

    Aabb bounds() {
        return index.bounds();
    }

    void overlapping(Aabb box, IntConsumer found) {
        index.overlapping(box, found);
    }
}
