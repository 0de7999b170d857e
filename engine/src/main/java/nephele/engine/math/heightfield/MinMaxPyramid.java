package nephele.engine.math.heightfield;

/**
 * A min-max pyramid: the least and greatest heights of square blocks of a grid's cells. Blocks of each level are twice
 * as wide as those of the level below, up to one block that covers everything. Blocks are addressed by arithmetic;
 * there are no nodes.
 */
final class MinMaxPyramid {
    /** Cells along a side of a block of the lowest level; with this size the pyramid adds 0.7 bytes per sample. */
    static final int BLOCK_CELLS = 4;

    private final int[] columns;
    private final int[] rows;
    private final int[] first;
    /** Least and greatest height of each block, by level, then row. */
    private final float[] ranges;

    /** @param samples in row-major order */
    MinMaxPyramid(float[] samples, int sampleColumns, int sampleRows) {
        int width = blocks(sampleColumns - 1, BLOCK_CELLS);
        int depth = blocks(sampleRows - 1, BLOCK_CELLS);
        int levels = 1 + 32 - Integer.numberOfLeadingZeros(Math.max(width, depth) - 1);
        columns = new int[levels];
        rows = new int[levels];
        first = new int[levels + 1];
        for (int level = 0; level < levels; level++) {
            columns[level] = width;
            rows[level] = depth;
            first[level + 1] = first[level] + width * depth;
            width = blocks(width, 2);
            depth = blocks(depth, 2);
        }
        ranges = new float[2 * first[levels]];
        fill(samples, sampleColumns, sampleRows, new SampleRange(0, 0, sampleColumns - 1, sampleRows - 1));
    }

    private MinMaxPyramid(MinMaxPyramid other) {
        columns = other.columns;
        rows = other.rows;
        first = other.first;
        ranges = other.ranges.clone();
    }

    /** Returns the pyramid of a grid of the same size whose heights differ in a range alone. */
    MinMaxPyramid edited(float[] samples, int sampleColumns, int sampleRows, SampleRange changed) {
        MinMaxPyramid edited = new MinMaxPyramid(this);
        edited.fill(samples, sampleColumns, sampleRows, changed);
        return edited;
    }

    /** Finds the blocks that a range of samples touches; neighbours share the samples of their border. */
    private void fill(float[] samples, int sampleColumns, int sampleRows, SampleRange changed) {
        int firstColumn = Math.max(0, changed.firstColumn() - 1) / BLOCK_CELLS;
        int firstRow = Math.max(0, changed.firstRow() - 1) / BLOCK_CELLS;
        int lastColumn = Math.min(changed.lastColumn() / BLOCK_CELLS, columns[0] - 1);
        int lastRow = Math.min(changed.lastRow() / BLOCK_CELLS, rows[0] - 1);
        for (int row = firstRow; row <= lastRow; row++) {
            for (int column = firstColumn; column <= lastColumn; column++) {
                fillFromSamples(column, row, samples, sampleColumns, sampleRows);
            }
        }
        for (int level = 1; level < columns.length; level++) {
            for (int row = firstRow >> level; row <= lastRow >> level; row++) {
                for (int column = firstColumn >> level; column <= lastColumn >> level; column++) {
                    fillFromBelow(level, column, row);
                }
            }
        }
    }

    private static int blocks(int parts, int partsOfBlock) {
        return (parts + partsOfBlock - 1) / partsOfBlock;
    }

    private void fillFromSamples(int column, int row, float[] samples, int sampleColumns, int sampleRows) {
        float least = Float.POSITIVE_INFINITY;
        float greatest = Float.NEGATIVE_INFINITY;
        int endRow = Math.min((row + 1) * BLOCK_CELLS, sampleRows - 1);
        int endColumn = Math.min((column + 1) * BLOCK_CELLS, sampleColumns - 1);
        for (int z = row * BLOCK_CELLS; z <= endRow; z++) {
            for (int x = column * BLOCK_CELLS; x <= endColumn; x++) {
                float height = samples[z * sampleColumns + x];
                least = Math.min(least, height);
                greatest = Math.max(greatest, height);
            }
        }
        keep(0, column, row, least, greatest);
    }

    private void fillFromBelow(int level, int column, int row) {
        float least = Float.POSITIVE_INFINITY;
        float greatest = Float.NEGATIVE_INFINITY;
        for (int child = 0; child < 4; child++) {
            int x = 2 * column + (child & 1);
            int z = 2 * row + (child >> 1);
            if (has(level - 1, x, z)) {
                least = Math.min(least, least(level - 1, x, z));
                greatest = Math.max(greatest, greatest(level - 1, x, z));
            }
        }
        keep(level, column, row, least, greatest);
    }

    private void keep(int level, int column, int row, float least, float greatest) {
        int at = at(level, column, row);
        ranges[at] = least;
        ranges[at + 1] = greatest;
    }

    private int at(int level, int column, int row) {
        return 2 * (first[level] + row * columns[level] + column);
    }

    /** Returns the level of the one block that covers everything; level 0 has the smallest blocks. */
    int top() {
        return columns.length - 1;
    }

    int columns(int level) {
        return columns[level];
    }

    int rows(int level) {
        return rows[level];
    }

    boolean has(int level, int column, int row) {
        return column < columns[level] && row < rows[level];
    }

    float least(int level, int column, int row) {
        return ranges[at(level, column, row)];
    }

    float greatest(int level, int column, int row) {
        return ranges[at(level, column, row) + 1];
    }
}
