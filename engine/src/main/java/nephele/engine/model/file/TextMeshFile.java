package nephele.engine.model.file;

import java.util.List;
import java.util.function.Predicate;
import nephele.engine.model.Mesh;
import nephele.engine.model.ModelText;
import nephele.engine.model.NumberFormatting;

/**
 * Reads the text of a {@code .3d} file: points, then normals, texture coordinates and triangles, each of these
 * optional; docs/models.md has the grammar.
 */
final class TextMeshFile {
    private final ModelText text;

    private NumberRows points;
    private NumberRows normals;
    private NumberRows texture;
    private NumberRows triangles;

    TextMeshFile(String file, byte[] bytes) {
        this.text = new ModelText(file, bytes, ",;");
    }

    Mesh read() {
        assign(new TextMeshBlocks(text).read());
        checkCoordinates(points);
        checkRows(normals, "normals");
        checkRows(texture, "texture coordinates");
        int[] indices = indices();
        float[] positions = points.toArray();
        float[] given = normals == null ? new float[positions.length] : normals.toArray();
        MissingNormals.fill(positions, given, indices);
        float[] pictures = texture == null ? new float[positions.length / 3 * 2] : texture.toArray();
        return new Mesh(positions, given, pictures, indices);
    }

    private void assign(List<NumberRows> blocks) {
        if (blocks.isEmpty()) {
            throw text.error("holds no points", "write x, y and z of a point in each line");
        }
        points = blocks.get(0);
        if (points.width() != 3) {
            throw text.wrongAt(points.line(0), "has " + points.width() + " numbers", "begin with points: x, y and z");
        }
        for (NumberRows block : blocks.subList(1, blocks.size())) {
            boolean last = block == blocks.get(blocks.size() - 1);
            assign(block, last ? this::holdsNormals : ignored -> true);
        }
    }

    /** @param isNormals returns true if a block of three numbers a row holds normals, false if triangles */
    private void assign(NumberRows block, Predicate<NumberRows> isNormals) {
        if (triangles != null) {
            throw text.wrongAt(block.line(0), "a block follows the triangles", "end the file with the triangles");
        } else if (block.width() == 2 && texture == null) {
            texture = block;
        } else if (block.width() == 3 && normals == null && texture == null && isNormals.test(block)) {
            normals = block;
        } else if (block.width() != 2 && block.rows() > 0) {
            triangles = block;
        } else {
            throw text.error("a block is empty or doubled", "keep to the blocks that docs/models.md names");
        }
    }

    /**
     * Returns true if the last block holds normals, judged by its first row. Non-negative integers are vertex indices
     * unless their length is 1 or 0, which three distinct indices cannot have.
     */
    private boolean holdsNormals(NumberRows block) {
        float x = block.at(0, 0);
        float y = block.at(0, 1);
        float z = block.at(0, 2);
        boolean whole = x == Math.rint(x) && y == Math.rint(y) && z == Math.rint(z);
        return !whole || x < 0 || y < 0 || z < 0 || Math.abs(x * x + y * y + z * z) <= 1;
    }

    private void checkRows(NumberRows rows, String what) {
        if (rows == null) {
            return;
        }
        checkCoordinates(rows);
        if (rows.rows() != points.rows()) {
            throw text.wrongAt(
                    rows.line(0),
                    "there are " + rows.rows() + " " + what + ", but " + points.rows() + " points",
                    "give each point one");
        }
    }

    private void checkCoordinates(NumberRows rows) {
        for (int row = 0; row < rows.rows(); row++) {
            for (int column = 0; column < rows.width(); column++) {
                if (!ModelText.isCoordinate(rows.at(row, column))) {
                    throw text.notACoordinate(rows.line(row), rows.at(row, column));
                }
            }
        }
    }

    private int[] indices() {
        return triangles == null ? eachPointOnce() : listed();
    }

    private int[] eachPointOnce() {
        int count = points.rows();
        if (count % 3 != 0) {
            throw text.wrongAt(
                    points.line(count - 1),
                    count + " points without triangles are no multiple of three",
                    "write three points for each triangle, or a block of triangles");
        }
        int[] indices = new int[count];
        for (int i = 0; i < count; i++) {
            indices[i] = i;
        }
        return indices;
    }

    private int[] listed() {
        int width = triangles.width();
        int[] indices = new int[triangles.rows() * width];
        if (indices.length % 3 != 0) {
            throw text.wrongAt(
                    triangles.line(triangles.rows() - 1),
                    indices.length + " indices are no multiple of three",
                    "write three for each triangle");
        }
        for (int i = 0; i < indices.length; i++) {
            float index = triangles.at(i / width, i % width);
            if (!(index >= 0 && index < points.rows() && index == Math.rint(index))) {
                throw text.wrongAt(
                        triangles.line(i / width),
                        NumberFormatting.of(index) + " names no point",
                        points.rows() == 0
                                ? "there are no points: write them first"
                                : "use whole numbers from 0 to " + (points.rows() - 1));
            }
            indices[i] = (int) index;
        }
        return indices;
    }
}
