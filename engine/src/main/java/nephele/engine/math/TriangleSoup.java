package nephele.engine.math;

import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.Set;

/**
 * Triangles as they come from a file: three vertex numbers each, counter-clockwise.
 *
 * @param positions x, y, z of each vertex
 * @param vertices three for each triangle
 */
public record TriangleSoup(double[] positions, int[] vertices) {
    /** Relative to the square of the extent: triangles with less area are slivers. */
    private static final double LEAST_AREA = 1e-12;

    public int triangleCount() {
        return vertices.length / 3;
    }

    /** Soup whose every triangle has a normal, and how many were dropped for having none or being there already. */
    public record Cleaned(TriangleSoup soup, int slivers, int duplicates) {}

    /** Drops slivers, and triangles with the vertices and winding of an earlier one. */
    public Cleaned cleaned() {
        double extent = extent();
        int[] kept = new int[vertices.length];
        int size = 0;
        int slivers = 0;
        int duplicates = 0;
        Set<Corners> seen = new LinkedHashSet<>();
        for (int at = 0; at < vertices.length; at += 3) {
            Corners corners = Corners.of(vertices[at], vertices[at + 1], vertices[at + 2]);
            if (!(doubledArea(at) > 2 * LEAST_AREA * extent * extent)) {
                slivers++;
            } else if (!seen.add(corners)) {
                duplicates++;
            } else {
                System.arraycopy(vertices, at, kept, size, 3);
                size += 3;
            }
        }
        return new Cleaned(new TriangleSoup(positions, Arrays.copyOf(kept, size)), slivers, duplicates);
    }

    /** Three vertices with the lowest first: equal for triangles that differ in where they begin. */
    private record Corners(int lowest, int next, int last) {
        static Corners of(int a, int b, int c) {
            if (a <= b && a <= c) {
                return new Corners(a, b, c);
            }
            return b <= c ? new Corners(b, c, a) : new Corners(c, a, b);
        }
    }

    /** The longest side of the box around all vertices. */
    public double extent() {
        double extent = 0;
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = axis; i < positions.length; i += 3) {
                low = Math.min(low, positions[i]);
                high = Math.max(high, positions[i]);
            }
            extent = Math.max(extent, high - low);
        }
        return extent;
    }

    private double doubledArea(int at) {
        int a = 3 * vertices[at];
        int b = 3 * vertices[at + 1];
        int c = 3 * vertices[at + 2];
        double[] p = positions;
        double abX = p[b] - p[a];
        double abY = p[b + 1] - p[a + 1];
        double abZ = p[b + 2] - p[a + 2];
        double acX = p[c] - p[a];
        double acY = p[c + 1] - p[a + 1];
        double acZ = p[c + 2] - p[a + 2];
        double x = abY * acZ - abZ * acY;
        double y = abZ * acX - abX * acZ;
        double z = abX * acY - abY * acX;
        return Math.sqrt(x * x + y * y + z * z);
    }
}
