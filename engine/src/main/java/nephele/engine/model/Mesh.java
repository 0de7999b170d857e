package nephele.engine.model;

/**
 * A triangle mesh with normals and texture coordinates. A point with several normals or texture coordinates is stored
 * as several vertices.
 *
 * @param positions x, y, z of each vertex
 * @param normals x, y, z of each vertex, of unit length, outward
 * @param textureCoordinates s, t of each vertex, from the bottom-left corner of the image
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

    /** Returns the number of triangles. */
    public int triangleCount() {
        return indices.length / 3;
    }
}
