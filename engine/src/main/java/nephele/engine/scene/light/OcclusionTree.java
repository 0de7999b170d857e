package nephele.engine.scene.light;

import java.util.Arrays;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;

/**
 * Answers whether a half-line meets any convex solid. Solids are tested as what lies behind all their planes: exact at
 * edges, so that touching solids leave no gap. Immutable and safe to share between threads.
 */
final class OcclusionTree {
    private static final int LEAF_SOLIDS = 2;

    private final double[][] planes;
    private final double[] boxes;
    private final int[] order;
    /** Per node: first solid and count for a leaf, right child and 0 for an inner node whose left child is next. */
    private final int[] nodes;

    private int nodeCount;

    OcclusionTree(List<Brush> brushes) {
        int n = brushes.size();
        planes = new double[n][];
        order = new int[n];
        Aabb[] bounds = new Aabb[n];
        for (int i = 0; i < n; i++) {
            planes[i] = flat(brushes.get(i).shape());
            bounds[i] = brushes.get(i).shape().bounds();
            order[i] = i;
        }
        nodes = new int[4 * Math.max(n, 1)];
        boxes = new double[12 * Math.max(n, 1)];
        if (n > 0) {
            build(bounds, 0, n);
        }
    }

    private static double[] flat(ConvexPolyhedron shape) {
        double[] flat = new double[4 * shape.faces().size()];
        for (int i = 0; i < shape.faces().size(); i++) {
            Plane p = shape.faces().get(i).plane();
            flat[4 * i] = p.nx();
            flat[4 * i + 1] = p.ny();
            flat[4 * i + 2] = p.nz();
            flat[4 * i + 3] = p.distance();
        }
        return flat;
    }

    private int build(Aabb[] bounds, int from, int to) {
        int node = nodeCount++;
        Aabb all = Aabb.EMPTY;
        for (int i = from; i < to; i++) {
            all = all.union(bounds[order[i]]);
        }
        store(node, all);
        if (to - from <= LEAF_SOLIDS) {
            nodes[2 * node] = from;
            nodes[2 * node + 1] = to - from;
            return node;
        }
        sortAlongLongestSide(bounds, all, from, to);
        int middle = (from + to) / 2;
        build(bounds, from, middle);
        nodes[2 * node] = build(bounds, middle, to);
        return node;
    }

    private void store(int node, Aabb b) {
        double[] box = {b.minX(), b.minY(), b.minZ(), b.maxX(), b.maxY(), b.maxZ()};
        System.arraycopy(box, 0, boxes, 6 * node, 6);
    }

    private void sortAlongLongestSide(Aabb[] bounds, Aabb all, int from, int to) {
        double x = all.maxX() - all.minX();
        double y = all.maxY() - all.minY();
        double z = all.maxZ() - all.minZ();
        Integer[] sorted = new Integer[to - from];
        Arrays.setAll(sorted, i -> order[from + i]);
        Arrays.sort(sorted, (a, b) -> {
            var ca = bounds[a].centre();
            var cb = bounds[b].centre();
            int byCentre = x >= y && x >= z
                    ? Double.compare(ca.x(), cb.x())
                    : y >= z ? Double.compare(ca.y(), cb.y()) : Double.compare(ca.z(), cb.z());
            return byCentre != 0 ? byCentre : Integer.compare(a, b);
        });
        for (int i = 0; i < sorted.length; i++) {
            order[from + i] = sorted[i];
        }
    }

    /** Inside or on the surface of a solid other than {@code except}. */
    boolean isInside(double[] p, int except) {
        for (int i = 0; i < planes.length; i++) {
            if (i != except && behindAll(planes[i], p)) {
                return true;
            }
        }
        return false;
    }

    private static boolean behindAll(double[] solid, double[] p) {
        for (int i = 0; i < solid.length; i += 4) {
            if (solid[i] * p[0] + solid[i + 1] * p[1] + solid[i + 2] * p[2] > solid[i + 3]) {
                return false;
            }
        }
        return true;
    }

    /** Whether the half-line from {@code o} along {@code d} meets a solid other than {@code except}. */
    boolean isOccluded(double[] o, double[] d, int except) {
        if (nodeCount == 0) {
            return false;
        }
        int[] stack = new int[64];
        int top = 0;
        stack[top++] = 0;
        while (top > 0) {
            int node = stack[--top];
            if (!meetsBox(node, o, d, Double.POSITIVE_INFINITY)) {
                continue;
            }
            int count = nodes[2 * node + 1];
            if (count == 0) {
                stack[top++] = nodes[2 * node];
                stack[top++] = node + 1;
            } else if (meetsLeaf(nodes[2 * node], count, except, o, d)) {
                return true;
            }
        }
        return false;
    }

    private boolean meetsLeaf(int first, int count, int except, double[] o, double[] d) {
        for (int i = first; i < first + count; i++) {
            if (order[i] != except && meetsSolid(planes[order[i]], o, d, Double.POSITIVE_INFINITY)) {
                return true;
            }
        }
        return false;
    }

    /** Whether a single solid meets every segment from {@code o} to {@code o + segments[i]}. */
    boolean oneMeetsAllSegments(double[] o, double[][] segments) {
        if (nodeCount == 0) {
            return false;
        }
        int[] stack = new int[64];
        int top = 0;
        stack[top++] = 0;
        while (top > 0) {
            int node = stack[--top];
            if (!meetsBox(node, o, segments[0], 1)) {
                continue;
            }
            int count = nodes[2 * node + 1];
            if (count == 0) {
                stack[top++] = nodes[2 * node];
                stack[top++] = node + 1;
            }
            for (int i = nodes[2 * node]; i < nodes[2 * node] + count; i++) {
                if (meetsAll(planes[order[i]], o, segments)) {
                    return true;
                }
            }
        }
        return false;
    }

    private static boolean meetsAll(double[] solid, double[] o, double[][] segments) {
        for (double[] segment : segments) {
            if (!meetsSolid(solid, o, segment, 1)) {
                return false;
            }
        }
        return true;
    }

    private boolean meetsBox(int node, double[] o, double[] d, double length) {
        double enter = 0;
        double leave = length;
        for (int axis = 0; axis < 3; axis++) {
            double low = boxes[6 * node + axis] - o[axis];
            double high = boxes[6 * node + 3 + axis] - o[axis];
            if (d[axis] == 0) {
                if (low > 0 || high < 0) {
                    return false;
                }
                continue;
            }
            double inverse = 1 / d[axis];
            enter = Math.max(enter, Math.min(low * inverse, high * inverse));
            leave = Math.min(leave, Math.max(low * inverse, high * inverse));
        }
        return enter <= leave;
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
