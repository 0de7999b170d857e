package nephele.engine.model.shape;

/** Joins rows of vertices by triangles. Seen from outside, columns run to the right and rows upwards. */
final class GridTriangles {
    /** The diagonal that splits a cell into two triangles. */
    enum Diagonal {
        /** The diagonal from the lower left to the upper right corner. */
        RISING,
        /** The diagonal from the upper left to the lower right corner. */
        FALLING
    }

    private GridTriangles() {}

    /** Joins {@code rows + 1} rows of {@code columns + 1} vertices, beginning at vertex {@code first}. */
    static void join(MeshBuilder mesh, int first, int columns, int rows, Diagonal diagonal) {
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                int lowerLeft = first + row * (columns + 1) + column;
                cell(mesh, lowerLeft, lowerLeft + columns + 1, diagonal);
            }
        }
    }

    private static void cell(MeshBuilder mesh, int lowerLeft, int upperLeft, Diagonal diagonal) {
        if (diagonal == Diagonal.RISING) {
            mesh.properTriangle(lowerLeft, lowerLeft + 1, upperLeft + 1);
            mesh.properTriangle(lowerLeft, upperLeft + 1, upperLeft);
        } else {
            mesh.properTriangle(lowerLeft, lowerLeft + 1, upperLeft);
            mesh.properTriangle(lowerLeft + 1, upperLeft + 1, upperLeft);
        }
    }
}
