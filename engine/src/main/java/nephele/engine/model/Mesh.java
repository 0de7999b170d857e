package nephele.engine.model;

/**
 * Triangles with normals and texture coordinates, as a drawing needs them: a point that faces with other normals or
 * other texture coordinates share is there once for each.
 *
 * @param positions x, y, z of each vertex
 * @param normals x, y, z of each vertex, of unit length, outward
 * @param textureCoordinates s, t of each vertex, from the picture's bottom-left corner
 * @param indices three vertices for each triangle, counter-clockwise seen from outside
 */
public record Mesh(float[] positions, float[] normals, float[] textureCoordinates, int[] indices) {
    public Mesh {
        if (normals.length != positions.length || textureCoordinates.length * 3 != positions.length * 2) {
            throw new IllegalArgumentException("every vertex has a position, a normal and texture coordinates");
        }
    }

    public int vertexCount() {
        return positions.length / 3;
    }

    public int triangleCount() {
        return indices.length / 3;
    }
}
