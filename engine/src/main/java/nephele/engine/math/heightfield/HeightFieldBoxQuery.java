package nephele.engine.math.heightfield;

import java.util.function.IntConsumer;
import nephele.engine.math.bvh.BoxTest;

/** A query for the triangles of a {@link HeightField} with boxes that pass a test. Used once. */
final class HeightFieldBoxQuery {
    private final HeightField field;
    private final MinMaxPyramid pyramid;
    private final BoxTest test;
    private final IntConsumer found;
    private final double[] box = new double[6];

    HeightFieldBoxQuery(HeightField field, BoxTest test, IntConsumer found) {
        this.field = field;
        this.test = test;
        this.found = found;
        pyramid = field.pyramid();
    }

    void walk() {
        visit(pyramid.top(), 0, 0);
    }

    private void visit(int level, int column, int row) {
        writeBlock(field, level, column, row, 0, box);
        if (!test.passes(box, 0)) {
            return;
        }
        if (level == 0) {
            visitCells(column, row);
            return;
        }
        for (int child = 0; child < 4; child++) {
            int x = 2 * column + (child & 1);
            int z = 2 * row + (child >> 1);
            if (pyramid.has(level - 1, x, z)) {
                visit(level - 1, x, z);
            }
        }
    }

    private void visitCells(int blockColumn, int blockRow) {
        int endRow = endCell(blockRow, 0, field.cellRows());
        int endColumn = endCell(blockColumn, 0, field.cellColumns());
        for (int row = firstCell(blockRow, 0); row < endRow; row++) {
            for (int column = firstCell(blockColumn, 0); column < endColumn; column++) {
                for (int half = 0; half < 2; half++) {
                    writeTriangle(field, column, row, half, 0, box);
                    if (test.passes(box, 0)) {
                        found.accept(triangle(field, column, row, half));
                    }
                }
            }
        }
    }

    static int firstCell(int block, int level) {
        return block * (MinMaxPyramid.BLOCK_CELLS << level);
    }

    static int endCell(int block, int level, int cells) {
        return Math.min(firstCell(block + 1, level), cells);
    }

    static int triangle(HeightField field, int column, int row, int half) {
        return 2 * (row * field.cellColumns() + column) + half;
    }

    /** Writes a block's bounds, grown by a margin: three minima, three maxima. */
    static void writeBlock(HeightField field, int level, int column, int row, double margin, double[] box) {
        box[0] = field.x(firstCell(column, level)) - margin;
        box[1] = field.y(field.pyramid().least(level, column, row)) - margin;
        box[2] = field.z(firstCell(row, level)) - margin;
        box[3] = field.x(endCell(column, level, field.cellColumns())) + margin;
        box[4] = field.y(field.pyramid().greatest(level, column, row)) + margin;
        box[5] = field.z(endCell(row, level, field.cellRows())) + margin;
    }

    /** Writes a triangle's bounds, grown by a margin: three minima, three maxima. */
    static void writeTriangle(HeightField field, int column, int row, int half, double margin, double[] box) {
        double least = field.height(column, row);
        double greatest = field.height(column + 1, row + 1);
        double between = half == 0 ? field.height(column, row + 1) : field.height(column + 1, row);
        box[0] = field.x(column) - margin;
        box[1] = field.y(Math.min(between, Math.min(least, greatest))) - margin;
        box[2] = field.z(row) - margin;
        box[3] = field.x(column + 1) + margin;
        box[4] = field.y(Math.max(between, Math.max(least, greatest))) + margin;
        box[5] = field.z(row + 1) + margin;
    }
}
