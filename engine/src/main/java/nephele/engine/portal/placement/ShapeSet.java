package nephele.engine.portal.placement;

import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.ItemVisitor;
import nephele.engine.math.SpatialIndex;

/** Convex polygons of one plane, found by place. */
final class ShapeSet {
    private final List<ConvexPolygon> shapes;
    private final SpatialIndex index;

    ShapeSet(List<ConvexPolygon> shapes) {
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

    void overlapping(Aabb box, ItemVisitor found) {
        index.overlapping(box, found);
    }
}
