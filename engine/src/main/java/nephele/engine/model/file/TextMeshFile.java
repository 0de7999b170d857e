package nephele.engine.model.file;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import nephele.engine.asset.MessageText;
import nephele.engine.model.Mesh;
import nephele.engine.model.MeshLimits;
import nephele.engine.model.ModelText;

/**
 * Reads the text of a {@code .3d} file: points, then normals, texture coordinates and triangles, each of these
 * optional; docs/models.md has the grammar.
 */
final class TextMeshFile {
    private static final int MOST_BLOCKS = 8;

    /** Maximum number of rows of one number, which are indices. */
    private static final int MOST_SINGLE_ROWS = 3 * MeshLimits.MAX_TRIANGLES;

    /** Maximum number of rows of more numbers, the same for points and triangles. */
    private static final int MOST_ROWS = MeshLimits.MAX_VERTICES;

    private final ModelText text;
    private final List<NumberRows> blocks = new ArrayList<>();
    private final float[] row = new float[3];

    /** The block to which rows are added; {@code null} after a blank line. */
    private NumberRows open;

    /** Row count announced for the open block; -1 if none. */
    private int announced = -1;

    private int announcedLine;

    private NumberRows points;
    private NumberRows normals;
    private NumberRows texture;
    private NumberRows triangles;

    TextMeshFile(String file, byte[] bytes) {
        this.text = new ModelText(file, bytes, ",;");
    }

    Mesh read() {
        readBlocks();
        assignBlocks();
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

    private void assignBlocks() {
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
                        MessageText.number(index) + " names no point",
                        points.rows() == 0
                                ? "there are no points: write them first"
                                : "use whole numbers from 0 to " + (points.rows() - 1));
            }
            indices[i] = (int) index;
        }
        return indices;
    }

    /**
     * Splits the text into blocks of rows. A block ends at a blank line, or at a row of one number followed by rows of
     * more numbers: that number is their count.
     */
    private void readBlocks() {
        while (text.hasNext()) {
            int numbers = text.nextNumbers(row);
            if (numbers == 0) {
                close();
            } else {
                add(numbers);
            }
        }
        close();
    }

    private void add(int numbers) {
        if (open != null && open.width() != numbers) {
            changeWidth(numbers);
        }
        if (open == null) {
            open = new NumberRows(width(numbers));
        }
        int most = open.width() == 1 ? MOST_SINGLE_ROWS : MOST_ROWS;
        if (open.rows() >= most) {
            throw text.error("has more than " + most + " rows in a block", "make the mesh coarser");
        }
        open.add(text.line(), row);
    }

    private int width(int numbers) {
        if (numbers > 3) {
            throw text.error(
                    "has " + numbers + " numbers in a row", "write 3 (points, normals, triangles) or 2 (texture)");
        }
        return numbers;
    }

    /** Handles a change of width, allowed only after or before a count. */
    private void changeWidth(int width) {
        if (open.width() == 1 && open.rows() == 1 && announced < 0) {
            announced = count(open.at(0, 0), open.line(0));
            announcedLine = open.line(0);
            open = null;
        } else if (width == 1) {
            close();
        } else {
            throw text.error(
                    "has " + width + " numbers, but the rows before have " + open.width(),
                    "write as many in each row, and a blank line between blocks");
        }
    }

    private int count(float value, int line) {
        if (!(value >= 0 && value <= MOST_SINGLE_ROWS && value == Math.rint(value))) {
            throw text.wrongAt(
                    line,
                    MessageText.number(value) + " is no number of rows",
                    "write how many rows follow, or leave it out");
        }
        return (int) value;
    }

    private void close() {
        if (open == null) {
            return;
        }
        NumberRows block = open.width() == 1 ? withoutCount(open) : open;
        if (announced >= 0 && block.rows() != announced) {
            throw text.wrongAt(
                    announcedLine,
                    announced + " rows are announced, but " + block.rows() + " follow",
                    "correct the count, or leave it out");
        }
        if (blocks.size() == MOST_BLOCKS) {
            throw text.error("has more than " + MOST_BLOCKS + " blocks", "keep to the four that docs/models.md names");
        }
        blocks.add(block);
        open = null;
        announced = -1;
    }

    /** Removes the leading count of a column of indices; without it, their number is a multiple of three. */
    private NumberRows withoutCount(NumberRows column) {
        if (column.rows() % 3 != 1) {
            return column;
        }
        announced = count(column.at(0, 0), column.line(0));
        announcedLine = column.line(0);
        var rest = new NumberRows(1);
        for (int row = 1; row < column.rows(); row++) {
            rest.add(column.line(row), new float[] {column.at(row, 0)});
        }
        return rest;
    }

    /** Rows of equally many numbers, each with its line in the file. */
    private static final class NumberRows {
        private final int width;
        private float[] numbers = new float[48];
        private int[] lines = new int[16];
        private int rows;

        NumberRows(int width) {
            this.width = width;
        }

        int width() {
            return width;
        }

        int rows() {
            return rows;
        }

        int line(int row) {
            return lines[row];
        }

        float at(int row, int column) {
            return numbers[row * width + column];
        }

        void add(int line, float[] row) {
            if (rows == lines.length) {
                lines = Arrays.copyOf(lines, 2 * rows);
            }
            if ((rows + 1) * width > numbers.length) {
                numbers = Arrays.copyOf(numbers, 2 * (rows + 1) * width);
            }
            System.arraycopy(row, 0, numbers, rows * width, width);
            lines[rows++] = line;
        }

        float[] toArray() {
            return Arrays.copyOf(numbers, rows * width);
        }
    }
}
