package nephele.engine.model.shape;

import java.util.Arrays;
import nephele.engine.model.Mesh;

/** A builder of a mesh with known maximum numbers of vertices and triangles. */
final class MeshBuilder {
    private final float[] positions;
    private final float[] normals;
    private final float[] textureCoordinates;
    private final int[] indices;
    private int vertices;
    private int corners;

    MeshBuilder(int mostVertices, int mostTriangles) {
        positions = new float[3 * mostVertices];
        normals = new float[3 * mostVertices];
        textureCoordinates = new float[2 * mostVertices];
        indices = new int[3 * mostTriangles];
    }

    /** Returns the index of the next vertex. */
    int nextVertex() {
        return vertices;
    }

    /** Begins a vertex; {@link #normal} must follow. */
    MeshBuilder point(double x, double y, double z) {
        put(positions, x, y, z);
        return this;
    }

    MeshBuilder normal(double x, double y, double z) {
        put(normals, x, y, z);
        return this;
    }

    /** Completes the vertex and returns its index. */
    int texture(double s, double t) {
        textureCoordinates[2 * vertices] = (float) s;
        textureCoordinates[2 * vertices + 1] = (float) t;
        return vertices++;
    }

    /** Adds a triangle, counter-clockwise seen from outside. */
    void triangle(int a, int b, int c) {
        indices[corners++] = a;
        indices[corners++] = b;
        indices[corners++] = c;
    }

    /** Adds a triangle unless two of its corners coincide. */
    private void properTriangle(int a, int b, int c) {
        if (!samePlace(a, b) && !samePlace(b, c) && !samePlace(c, a)) {
            triangle(a, b, c);
        }
    }

    /**
     * Joins {@code rows + 1} rows of {@code columns + 1} vertices, beginning at vertex {@code first}. Seen from outside,
     * columns run to the right and rows upwards; the cells' diagonals fall from the upper left to the lower right corner.
     */
    void grid(int first, int columns, int rows) {
        grid(first, columns, rows, false);
    }

    /** Joins vertices likewise, with diagonals that fall, or rise from the lower left to the upper right corner. */
    void grid(int first, int columns, int rows, boolean isRising) {
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                int lowerLeft = first + row * (columns + 1) + column;
                int upperLeft = lowerLeft + columns + 1;
                properTriangle(lowerLeft, lowerLeft + 1, isRising ? upperLeft + 1 : upperLeft);
                properTriangle(isRising ? lowerLeft : lowerLeft + 1, upperLeft + 1, upperLeft);
            }
        }
    }

    Mesh mesh() {
        boolean full = 3 * vertices == positions.length && corners == indices.length;
        return full
                ? new Mesh(positions, normals, textureCoordinates, indices)
                : new Mesh(
                        Arrays.copyOf(positions, 3 * vertices),
                        Arrays.copyOf(normals, 3 * vertices),
                        Arrays.copyOf(textureCoordinates, 2 * vertices),
                        Arrays.copyOf(indices, corners));
    }

    /** Adding 0 turns -0 into 0, so that texts do not distinguish them. */
    private void put(float[] to, double x, double y, double z) {
        to[3 * vertices] = (float) x + 0f;
        to[3 * vertices + 1] = (float) y + 0f;
        to[3 * vertices + 2] = (float) z + 0f;
    }

    private boolean samePlace(int a, int b) {
        return positions[3 * a] == positions[3 * b]
                && positions[3 * a + 1] == positions[3 * b + 1]
                && positions[3 * a + 2] == positions[3 * b + 2];
    }
}
