package nephele.engine.level.placed;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.SpatialIndex;

/** How many boxes of a level's triangles each one overlaps on average: what rays and sweeps among them have to test. */
final class TriangleOverlap {
    /** Beyond, a tick takes a tenth of a second and more. A closed mesh of small triangles has 10 to 30. */
    static final int MOST_OVERLAPS = 4_000;

    private static final int SAMPLES = 64;

    private final List<Aabb> boxes = new ArrayList<>();

    /** @param models of which only the surfaces count: a convex solid is one shape */
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

    /** How many boxes a sample's box meets on average, in every run alike; 0 where there are too few to be too many. */
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
