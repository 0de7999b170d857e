package nephele.editor.terrain;

import nephele.engine.math.heightfield.SampleRange;

/** Means of values over rectangles of samples, from sums over all rectangles that begin at a corner (Crow 1984). */
final class BoxMean {
    private final SampleRange part;
    private final int halfColumns;
    private final int halfRows;
    private final int stride;
    private final double[] sums;

    /** @param part the samples that means may need; those beyond it do not count */
    BoxMean(float[] values, TerrainGrid grid, SampleRange part, int halfColumns, int halfRows) {
        this.part = part;
        this.halfColumns = halfColumns;
        this.halfRows = halfRows;
        stride = part.columns() + 1;
        sums = new double[stride * (part.rows() + 1)];
        for (int row = 0; row < part.rows(); row++) {
            double sum = 0;
            int from = (part.firstRow() + row) * grid.columns() + part.firstColumn();
            for (int column = 0; column < part.columns(); column++) {
                sum += values[from + column];
                sums[(row + 1) * stride + column + 1] = sums[row * stride + column + 1] + sum;
            }
        }
    }

    /** Returns the mean over the samples around one. */
    double around(int column, int row) {
        int left = Math.max(column - halfColumns, part.firstColumn()) - part.firstColumn();
        int right = Math.min(column + halfColumns, part.lastColumn()) - part.firstColumn() + 1;
        int top = Math.max(row - halfRows, part.firstRow()) - part.firstRow();
        int bottom = Math.min(row + halfRows, part.lastRow()) - part.firstRow() + 1;
        double sum = sums[bottom * stride + right]
                - sums[bottom * stride + left]
                - sums[top * stride + right]
                + sums[top * stride + left];
        return sum / ((right - left) * (bottom - top));
    }
}
