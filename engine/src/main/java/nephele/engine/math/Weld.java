package nephele.engine.math;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;

/**
 * Closes a soup's cracks: vertices closer than the tolerance become one, bit for bit, and an edge that runs through a
 * vertex of its neighbour (a T-junction) is split there, so that the rasteriser steps along the same pixels on both
 * sides.
 */
public final class Weld {
    /** Relative to the soup's extent. */
    private static final double TOLERANCE = 1e-4;

    /** On average; only a file made to exhaust memory has more vertices on its edges. */
    private static final long MOST_SPLITS_PER_TRIANGLE = 100;

    private final double[] positions;
    private final double tolerance;
    private final SpatialIndex vertexIndex;
    private final ItemList near = new ItemList();

    private Weld(double[] positions, double tolerance) {
        this.positions = positions;
        this.tolerance = tolerance;
        vertexIndex = SpatialIndex.of(boxes(positions));
    }

    public static TriangleSoup closed(TriangleSoup soup) {
        double tolerance = TOLERANCE * soup.extent();
        TriangleSoup joined = new Weld(soup.positions(), tolerance).joined(soup.vertices());
        return new Weld(joined.positions(), tolerance).withoutTJunctions(joined.vertices());
    }

    private static List<Aabb> boxes(double[] positions) {
        List<Aabb> boxes = new ArrayList<>(positions.length / 3);
        for (int i = 0; i < positions.length; i += 3) {
            double x = positions[i];
            double y = positions[i + 1];
            double z = positions[i + 2];
            boxes.add(new Aabb(x, y, z, x, y, z));
        }
        return boxes;
    }

    private TriangleSoup joined(int[] vertices) {
        int[] renumbered = new int[positions.length / 3];
        Arrays.fill(renumbered, -1);
        double[] kept = new double[positions.length];
        int count = 0;
        for (int vertex = 0; vertex < renumbered.length; vertex++) {
            if (renumbered[vertex] >= 0) {
                continue;
            }
            System.arraycopy(positions, 3 * vertex, kept, 3 * count, 3);
            near.clear();
            vertexIndex.overlapping(around(vertex), near);
            for (int i = 0; i < near.size(); i++) {
                if (renumbered[near.get(i)] < 0) {
                    renumbered[near.get(i)] = count;
                }
            }
            count++;
        }
        return new TriangleSoup(Arrays.copyOf(kept, 3 * count), renumbered(vertices, renumbered));
    }

    /** Without those that have lost a corner. */
    private static int[] renumbered(int[] vertices, int[] renumbered) {
        int[] triangles = new int[vertices.length];
        int size = 0;
        for (int at = 0; at < vertices.length; at += 3) {
            int a = renumbered[vertices[at]];
            int b = renumbered[vertices[at + 1]];
            int c = renumbered[vertices[at + 2]];
            if (a != b && b != c && c != a) {
                triangles[size++] = a;
                triangles[size++] = b;
                triangles[size++] = c;
            }
        }
        return Arrays.copyOf(triangles, size);
    }

    private Aabb around(int vertex) {
        int at = 3 * vertex;
        return new Aabb(
                        positions[at],
                        positions[at + 1],
                        positions[at + 2],
                        positions[at],
                        positions[at + 1],
                        positions[at + 2])
                .grown(tolerance);
    }

    private TriangleSoup withoutTJunctions(int[] vertices) {
        List<int[]> done = new ArrayList<>();
        Deque<int[]> open = new ArrayDeque<>();
        for (int at = 0; at < vertices.length; at += 3) {
            open.add(new int[] {vertices[at], vertices[at + 1], vertices[at + 2]});
        }
        long most = MOST_SPLITS_PER_TRIANGLE * (long) open.size();
        while (!open.isEmpty()) {
            int[] triangle = open.remove();
            boolean mayGrow = done.size() + open.size() < most;
            if (!mayGrow || !split(triangle, open)) {
                done.add(triangle);
            }
        }
        return new TriangleSoup(
                positions, done.stream().flatMapToInt(Arrays::stream).toArray());
    }

    private boolean split(int[] triangle, Deque<int[]> open) {
        for (int edge = 0; edge < 3; edge++) {
            int from = triangle[edge];
            int to = triangle[(edge + 1) % 3];
            int opposite = triangle[(edge + 2) % 3];
            int between = vertexOn(from, to, opposite);
            if (between >= 0) {
                open.add(new int[] {from, between, opposite});
                open.add(new int[] {between, to, opposite});
                return true;
            }
        }
        return false;
    }

    /** The lowest vertex within the tolerance of an edge and between its ends; −1 without one. */
    private int vertexOn(int from, int to, int opposite) {
        near.clear();
        vertexIndex.overlapping(around(from).union(around(to)), near);
        int lowest = -1;
        for (int i = 0; i < near.size(); i++) {
            int vertex = near.get(i);
            boolean corner = vertex == from || vertex == to || vertex == opposite;
            if (!corner && (lowest < 0 || vertex < lowest) && liesBetween(vertex, from, to)) {
                lowest = vertex;
            }
        }
        return lowest;
    }

    private boolean liesBetween(int vertex, int from, int to) {
        double ex = positions[3 * to] - positions[3 * from];
        double ey = positions[3 * to + 1] - positions[3 * from + 1];
        double ez = positions[3 * to + 2] - positions[3 * from + 2];
        double px = positions[3 * vertex] - positions[3 * from];
        double py = positions[3 * vertex + 1] - positions[3 * from + 1];
        double pz = positions[3 * vertex + 2] - positions[3 * from + 2];
        double length = Math.sqrt(ex * ex + ey * ey + ez * ez);
        double along = (px * ex + py * ey + pz * ez) / length;
        double square = px * px + py * py + pz * pz - along * along;
        return along > tolerance && along < length - tolerance && square <= tolerance * tolerance;
    }
}
