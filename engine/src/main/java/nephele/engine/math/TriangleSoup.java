package nephele.engine.math;

/**
 * Triangles as they come from a file: three vertex numbers each, counter-clockwise.
 *
 * @param positions x, y, z of each vertex
 * @param vertices three for each triangle
 */
public record TriangleSoup(double[] positions, int[] vertices) {
    public int triangleCount() {
        return vertices.length / 3;
    }
}
