package nephele.engine.scene.light;

import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.SampleRange;

/**
 * A rectangle of changed heights as seen from places of the ground.
 *
 * @param top the greatest world y in it, before and after
 */
record SeenChange(double minX, double minZ, double maxX, double maxZ, double top) {
    /** The smooth normal of a place depends on samples of so many cells around it. */
    private static final int NORMAL_CELLS = 2;

    /** Horizons are floats. */
    private static final double ROUNDING = 1e-6;

    /** @param before has other heights in the range */
    static SeenChange of(HeightField before, HeightField field, SampleRange changed) {
        SampleRange reach = changed.grown(NORMAL_CELLS);
        return new SeenChange(
                field.x(reach.firstColumn()),
                field.z(reach.firstRow()),
                field.x(reach.lastColumn()),
                field.z(reach.lastRow()),
                Math.max(top(before, reach), top(field, reach)));
    }

    private static double top(HeightField field, SampleRange range) {
        float top = Float.NEGATIVE_INFINITY;
        for (int row = Math.max(0, range.firstRow()); row <= Math.min(range.lastRow(), field.cellRows()); row++) {
            int last = Math.min(range.lastColumn(), field.cellColumns());
            for (int column = Math.max(0, range.firstColumn()); column <= last; column++) {
                top = Math.max(top, field.height(column, row));
            }
        }
        return field.y(top);
    }

    boolean isAt(double x, double z) {
        return x >= minX && x <= maxX && z >= minZ && z <= maxZ;
    }

    /**
     * Returns true if the horizon of a place may be another one: not where the rectangle is not met, nor where all of it,
     * before and after, is below the horizon that was found.
     *
     * @param y of the ground there
     * @param horizon the tangent of its elevation before
     */
    boolean changesHorizon(double x, double y, double z, double towardsX, double towardsZ, double horizon) {
        double toMinX = (minX - x) / towardsX;
        double toMaxX = (maxX - x) / towardsX;
        double toMinZ = (minZ - z) / towardsZ;
        double toMaxZ = (maxZ - z) / towardsZ;
        double enter = Math.max(Math.min(toMinX, toMaxX), Math.min(toMinZ, toMaxZ));
        double leave = Math.min(Math.max(toMinX, toMaxX), Math.max(toMinZ, toMaxZ));
        if (leave < Math.max(enter, 0)) {
            return false;
        }
        double highest = (top - y) / (top > y ? enter : leave);
        return enter <= 0 || !(highest < horizon - ROUNDING * (1 + Math.abs(horizon)));
    }
}
