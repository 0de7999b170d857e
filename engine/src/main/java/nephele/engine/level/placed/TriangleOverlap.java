package nephele.engine.level.placed;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.SpatialIndex;

/**
 * Estimates how many triangle bounds each triangle's bounds overlap on average, which is the number of triangles that
 * rays and sweeps must test there.
 */
final class TriangleOverlap {
    /** Above this mean, a tick takes a tenth of a second or more. A closed mesh of small triangles has 10 to 30. */
    static final int MOST_OVERLAPS = 4_000;

    private static final int SAMPLES = 64;

    private final List<Aabb> boxes = new ArrayList<>();

    /** @param models those with only a surface are counted; a convex solid is a single shape */
    TriangleOverlap(List<PlacedModel> models) {
        for (PlacedModel model : models) {
            for (int i = 0; model.solid() == null && i < model.triangles().count(); i++) {
                boxes.add(Aabb.of(List.of(corner(model, i, 0), corner(model, i, 1), corner(model, i, 2))));
            }
        }
    }

    private static Vec3 corner(PlacedModel model, int triangle, int corner) {
        return model.triangles().corner(triangle, corner);
    }

    /** Returns the mean number of boxes that a sample's box overlaps, the same in every run; 0 for few boxes. */
    long meanOverlaps() {
        if (boxes.size() <= MOST_OVERLAPS) {
            return 0;
        }
        SpatialIndex index = SpatialIndex.of(boxes);
        long[] overlaps = {0};
        for (int i = 0; i < SAMPLES; i++) {
            index.overlapping(boxes.get((int) ((i + 0.5) * boxes.size() / SAMPLES)), other -> overlaps[0]++);
        }
        return overlaps[0] / SAMPLES;
    }
}
