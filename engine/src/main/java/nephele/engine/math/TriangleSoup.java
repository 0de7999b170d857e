package nephele.engine.math;

/**
 * Triangles as read from a file: three vertex indices each, counter-clockwise.
 *
 * @param positions x, y, z of each vertex
 * @param vertices three indices for each triangle
 */
public record TriangleSoup(double[] positions, int[] vertices) {
    public int triangleCount() {
        return vertices.length / 3;
    }
}
