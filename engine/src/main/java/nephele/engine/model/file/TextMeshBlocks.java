package nephele.engine.model.file;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.model.MeshLimits;
import nephele.engine.model.ModelText;
import nephele.engine.model.NumberFormatting;

/**
 * Splits the text of a {@code .3d} file into blocks of rows. A block ends at a blank line, or at a row of one number
 * followed by rows of more numbers: that number is their count.
 */
final class TextMeshBlocks {
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

    TextMeshBlocks(ModelText text) {
        this.text = text;
    }

    List<NumberRows> read() {
        while (text.hasNext()) {
            int numbers = text.nextNumbers(row);
            if (numbers == 0) {
                close();
            } else {
                add(numbers);
            }
        }
        close();
        return blocks;
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
                    NumberFormatting.of(value) + " is no number of rows",
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
}
