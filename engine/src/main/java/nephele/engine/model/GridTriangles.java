package nephele.engine.model;

/** Rows of vertices joined by triangles; columns run to the right and rows upward, seen from outside. */
final class GridTriangles {
    /** Which diagonal cuts a cell in two. */
    enum Diagonal {
        /** From the lower left corner to the upper right one. */
        RISING,
        /** From the upper left corner to the lower right one. */
        FALLING
    }

    private GridTriangles() {}

    /** Joins {@code columns + 1} vertices in each of {@code rows + 1} rows, the first of which is {@code first}. */
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
