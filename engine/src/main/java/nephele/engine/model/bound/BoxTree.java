package nephele.engine.model.bound;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.BiPredicate;
import java.util.function.Predicate;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** The triangles of a model in a binary tree of boxes along the model's axes; a leaf has one triangle. Immutable. */
public final class BoxTree {
    private static final Pose STILL = new Pose(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), Vec3.ZERO);

    private final Aabb box;
    /** The corners of a leaf's triangle; {@code null} of a branch. */
    private final Vec3[] triangle;

    private final BoxTree low;
    private final BoxTree high;

    private BoxTree(Aabb box, Vec3[] triangle, BoxTree low, BoxTree high) {
        this.box = box;
        this.triangle = triangle;
        this.low = low;
        this.high = high;
    }

    /** @param triangles three corners each, at least one triangle */
    public static BoxTree of(Vec3[][] triangles) {
        Aabb box = Aabb.EMPTY;
        for (Vec3[] triangle : triangles) {
            box = box.union(Aabb.of(Arrays.asList(triangle)));
        }
        if (triangles.length == 1) {
            return new BoxTree(box, triangles[0], null, null);
        }
        int axis = longest(box);
        Vec3[][] sorted = triangles.clone();
        Arrays.sort(sorted, Comparator.comparingDouble(triangle -> sum(triangle, axis)));
        int half = sorted.length / 2;
        return new BoxTree(
                box, null, of(Arrays.copyOf(sorted, half)), of(Arrays.copyOfRange(sorted, half, sorted.length)));
    }

    private static int longest(Aabb box) {
        double x = box.maxX() - box.minX();
        double y = box.maxY() - box.minY();
        double z = box.maxZ() - box.minZ();
        return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    }

    private static double sum(Vec3[] triangle, int axis) {
        Vec3 all = triangle[0].plus(triangle[1]).plus(triangle[2]);
        return axis == 0 ? all.x() : axis == 1 ? all.y() : all.z();
    }

    public Aabb box() {
        return box;
    }

    /** Returns whether a leaf's box has a point in common with a ball and its triangle passes a test. */
    boolean touches(Vec3 centre, double radius, Predicate<Vec3[]> test) {
        if (box.nearest(centre) > radius) {
            return false;
        }
        return triangle == null
                ? low.touches(centre, radius, test) || high.touches(centre, radius, test)
                : test.test(triangle);
    }

    /** Adds the boxes of a level of the tree, and the leaves' above it. */
    void addBoxes(int levelsBelow, List<Aabb> boxes) {
        if (triangle != null || levelsBelow == 0) {
            boxes.add(box);
        } else {
            low.addBoxes(levelsBelow - 1, boxes);
            high.addBoxes(levelsBelow - 1, boxes);
        }
    }

    /** Adds the corners of all triangles. */
    void addTriangles(List<Vec3[]> triangles) {
        if (triangle != null) {
            triangles.add(triangle);
        } else {
            low.addTriangles(triangles);
            high.addTriangles(triangles);
        }
    }

    /**
     * Returns whether two leaves are in contact: their boxes touch, and so do their triangles by a test.
     *
     * @param pose the pose of the other model as this one sees it
     */
    boolean touches(BoxTree other, Pose pose, BiPredicate<Vec3[], Vec3[]> test) {
        return touches(OrientedBox.of(box, STILL), other, OrientedBox.of(other.box, pose), pose, test);
    }

    private boolean touches(
            OrientedBox own, BoxTree other, OrientedBox others, Pose pose, BiPredicate<Vec3[], Vec3[]> test) {
        if (!own.touches(others)) {
            return false;
        }
        if (triangle != null && other.triangle != null) {
            return test.test(triangle, moved(other.triangle, pose));
        }
        boolean isOwnSplit = other.triangle != null
                || triangle == null && own.half().length() >= others.half().length();
        if (isOwnSplit) {
            return low.touches(OrientedBox.of(low.box, STILL), other, others, pose, test)
                    || high.touches(OrientedBox.of(high.box, STILL), other, others, pose, test);
        }
        return touches(own, other.low, OrientedBox.of(other.low.box, pose), pose, test)
                || touches(own, other.high, OrientedBox.of(other.high.box, pose), pose, test);
    }

    private static Vec3[] moved(Vec3[] triangle, Pose by) {
        return new Vec3[] {by.moved(triangle[0]), by.moved(triangle[1]), by.moved(triangle[2])};
    }
}
