package nephele.editor.tool.clip;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import nephele.engine.math.Aabb;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/**
 * The points that give a plane: two and the direction of sight of a plan, or three.
 *
 * @param sight the direction of sight of the plan; {@code null} for points in the perspective view
 */
record ClipPoints(Vec3 sight, List<Vec3> points) {
    private static final double FAR_METRES = 1e8;
    private static final double NEAR_METRES = 1e-3;

    static ClipPoints none(Vec3 sight) {
        return new ClipPoints(sight, List.of());
    }

    boolean isComplete() {
        return points.size() == (sight == null ? 3 : 2);
    }

    ClipPoints with(Vec3 point) {
        List<Vec3> more = new ArrayList<>(points);
        more.add(point);
        return new ClipPoints(sight, List.copyOf(more));
    }

    ClipPoints with(int index, Vec3 point) {
        List<Vec3> others = new ArrayList<>(points);
        others.set(index, point);
        return new ClipPoints(sight, List.copyOf(others));
    }

    /** Returns the plane; empty while points are missing or lie on a line. */
    Optional<Plane> plane() {
        if (!isComplete()) {
            return Optional.empty();
        }
        Vec3 along = points.get(1).minus(points.get(0));
        Vec3 normal = along.cross(sight == null ? points.get(2).minus(points.get(0)) : sight);
        if (!(normal.length() > 0)) {
            return Optional.empty();
        }
        return Optional.of(Plane.through(Plane.of(normal, 0).normal(), points.get(0)));
    }

    /** Returns the box around the points, as deep as the world in a plan. */
    Aabb reach() {
        Aabb box = Aabb.of(points).grown(NEAR_METRES);
        return sight == null
                ? box
                : box.union(box.moved(sight.scaled(FAR_METRES))).union(box.moved(sight.scaled(-FAR_METRES)));
    }
}
