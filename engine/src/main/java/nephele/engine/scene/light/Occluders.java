package nephele.engine.scene.light;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.ItemRayTest;
import nephele.engine.math.Ray;
import nephele.engine.math.SpatialIndex;
import nephele.engine.math.TriangleMeeting;
import nephele.engine.math.Vec3;

/**
 * Answers whether a half-line meets anything that never moves. Convex solids are tested as what lies behind all their
 * planes: exact at edges, so that touching solids leave no gap. Items are the level's solids, then its convex models,
 * then the triangles of the others. Immutable and safe to share between threads.
 */
final class Occluders {
    private final double[][] planes;
    private final double[] triangles;
    private final SpatialIndex index;

    Occluders(List<Brush> brushes) {
        this(StaticShapes.of(brushes));
    }

    Occluders(StaticShapes shapes) {
        List<Brush> convex = new ArrayList<>(shapes.solids());
        convex.addAll(shapes.models().solids());
        planes = convex.stream().map(brush -> brush.shape().flatPlanes()).toArray(double[][]::new);
        triangles = shapes.models().sheets().stream()
                .flatMapToDouble(model -> Arrays.stream(model.triangles().corners()))
                .toArray();
        List<Aabb> boxes = new ArrayList<>();
        convex.forEach(brush -> boxes.add(brush.shape().bounds()));
        for (int at = 0; at < triangles.length; at += 9) {
            boxes.add(Aabb.of(List.of(corner(at), corner(at + 3), corner(at + 6))));
        }
        index = SpatialIndex.of(boxes);
    }

    private Vec3 corner(int at) {
        return new Vec3(triangles[at], triangles[at + 1], triangles[at + 2]);
    }

    /** Inside or on the surface of a solid other than {@code except}; nothing is inside a surface that is not closed. */
    boolean isInside(double[] p, int except) {
        boolean[] inside = new boolean[1];
        index.passing(
                (boxes, at) -> !inside[0] && holds(boxes, at, p),
                item -> inside[0] |= item != except && item < planes.length && behindAll(planes[item], p));
        return inside[0];
    }

    private static boolean holds(double[] boxes, int at, double[] p) {
        return boxes[at] <= p[0]
                && p[0] <= boxes[at + 3]
                && boxes[at + 1] <= p[1]
                && p[1] <= boxes[at + 4]
                && boxes[at + 2] <= p[2]
                && p[2] <= boxes[at + 5];
    }

    private static boolean behindAll(double[] solid, double[] p) {
        for (int i = 0; i < solid.length; i += 4) {
            if (solid[i] * p[0] + solid[i + 1] * p[1] + solid[i + 2] * p[2] > solid[i + 3]) {
                return false;
            }
        }
        return true;
    }

    /** Whether the half-line from {@code o} along {@code d} meets an item other than {@code except}. */
    boolean isOccluded(double[] o, double[] d, int except) {
        return index.anyHit(
                new Ray(o[0], o[1], o[2], d[0], d[1], d[2]),
                Double.MAX_VALUE,
                (ray, item, limit) -> answer(item != except && meets(item, o, d, limit)));
    }

    int items() {
        return index.size();
    }

    /** How many boxes are tested for the answer of {@link #isOccluded}, which {@code hit} receives. */
    int boxTests(double[] o, double[] d, int except, boolean[] hit) {
        Ray ray = new Ray(o[0], o[1], o[2], d[0], d[1], d[2]);
        int[] tests = new int[1];
        index.passing(
                (boxes, at) -> {
                    tests[0] += hit[0] ? 0 : 1;
                    return !hit[0] && ray.boxEntry(boxes, at, Double.MAX_VALUE) < Double.POSITIVE_INFINITY;
                },
                item -> hit[0] = hit[0] || item != except && meets(item, o, d, Double.MAX_VALUE));
        return tests[0];
    }

    /** For callers that keep their test: whether it hits any item up to {@code limit}. */
    boolean anyHit(Ray ray, double limit, ItemRayTest test) {
        return index.anyHit(ray, limit, test);
    }

    /** The answer of such a test for one item. */
    double hit(int item, double[] o, double[] d, double limit) {
        return answer(meets(item, o, d, limit));
    }

    /** Whether a single solid meets every segment from {@code o} to {@code o + segments[i]}. */
    boolean oneMeetsAllSegments(double[] o, double[][] segments) {
        double[] first = segments[0];
        return index.anyHit(
                new Ray(o[0], o[1], o[2], first[0], first[1], first[2]),
                1,
                (ray, item, limit) -> answer(meetsAll(item, o, segments)));
    }

    private static double answer(boolean hit) {
        return hit ? 0 : Double.POSITIVE_INFINITY;
    }

    private boolean meetsAll(int item, double[] o, double[][] segments) {
        for (double[] segment : segments) {
            if (!meets(item, o, segment, 1)) {
                return false;
            }
        }
        return true;
    }

    private boolean meets(int item, double[] o, double[] d, double length) {
        if (item < planes.length) {
            return meetsSolid(planes[item], o, d, length);
        }
        int at = 9 * (item - planes.length);
        double t = TriangleMeeting.parameter(o[0], o[1], o[2], d[0], d[1], d[2], triangles, at);
        return t >= 0 && t <= length;
    }

    /** Clips o + t · d, 0 ≤ t ≤ length, by every plane (Cyrus and Beck 1978); what is left lies inside. */
    private static boolean meetsSolid(double[] solid, double[] o, double[] d, double length) {
        double enter = 0;
        double leave = length;
        for (int i = 0; i < solid.length; i += 4) {
            double along = solid[i] * d[0] + solid[i + 1] * d[1] + solid[i + 2] * d[2];
            double distance = solid[i + 3] - solid[i] * o[0] - solid[i + 1] * o[1] - solid[i + 2] * o[2];
            if (along > 0) {
                leave = Math.min(leave, distance / along);
            } else if (along < 0) {
                enter = Math.max(enter, distance / along);
            } else if (distance < 0) {
                return false;
            }
            if (enter > leave) {
                return false;
            }
        }
        return true;
    }
}
