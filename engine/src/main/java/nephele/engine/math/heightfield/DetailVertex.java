package nephele.engine.math.heightfield;

/**
 * A vertex of a tile as {@code terrain-detail.glsl} places it, in double precision.
 *
 * @param column columns from the field's first sample
 * @param row rows from the field's first sample
 * @param height metres above the field's origin
 */
public record DetailVertex(double column, double row, double height) {
    /** Shortly before the range; covers the rounding of a shader. */
    private static final double SLIDE_END = 0.999;

    /**
     * Returns a vertex.
     *
     * @param tile {@link DetailTiles#FLOATS} from {@code at} on
     * @param x 0 to {@link HeightFieldDetail#TILE_CELLS}
     * @param z the same
     */
    public static DetailVertex of(HeightField field, DetailView view, float[] tile, int at, int x, int z) {
        int between = (int) tile[at + 2];
        int column = Math.min((int) tile[at] + between * x, field.cellColumns());
        int row = Math.min((int) tile[at + 1] + between * z, field.cellRows());
        double height = field.height(column, row);
        int asideX = column & between;
        int asideZ = row & between;
        double fraction = range(field, view, column, row)
                / endOfSliding(tile, at, column - (int) tile[at], row - (int) tile[at + 1], between);
        if (fraction <= DetailRanges.MORPH_START || (asideX | asideZ) == 0) {
            return new DetailVertex(column, row, height);
        }
        double end = field.height(column - asideX, row - asideZ);
        int otherColumn = Math.min(column + asideX, field.cellColumns());
        double coarser = 0.5 * (end + field.height(otherColumn, Math.min(row + asideZ, field.cellRows())));
        if (fraction >= SLIDE_END) {
            return new DetailVertex(column - asideX, row - asideZ, end);
        }
        double risen = Math.min(
                1, (fraction - DetailRanges.MORPH_START) / (DetailRanges.MORPH_END - DetailRanges.MORPH_START));
        double slid = Math.max(0, (fraction - DetailRanges.SLIDE_START) / (SLIDE_END - DetailRanges.SLIDE_START));
        double raised = mix(height, coarser, risen);
        return new DetailVertex(column - slid * asideX, row - slid * asideZ, mix(raised, end, slid));
    }

    private static double range(HeightField field, DetailView view, int column, int row) {
        return view.range(
                field.x(column) - view.eye().x(),
                field.y(field.height(column, row)) - view.eye().y(),
                field.z(row) - view.eye().z());
    }

    private static double endOfSliding(float[] tile, int at, int x, int z, int between) {
        double across = (double) x / (HeightFieldDetail.TILE_CELLS * between);
        double along = (double) z / (HeightFieldDetail.TILE_CELLS * between);
        return mix(mix(tile[at + 4], tile[at + 5], across), mix(tile[at + 6], tile[at + 7], across), along);
    }

    private static double mix(double a, double b, double fraction) {
        return a * (1 - fraction) + b * fraction;
    }
}
