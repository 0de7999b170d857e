package nephele.editor.terrain;

import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalDouble;
import nephele.editor.terrain.TerrainBrush.Effect;
import nephele.editor.text.Words;
import nephele.engine.asset.HeightMap;
import nephele.engine.level.Terrain;
import nephele.engine.math.heightfield.SampleRange;

/**
 * A stroke on heights. They are floats in units of the map while it goes on, so that dabs of less than a unit add up,
 * and stay within what the map can hold.
 */
public final class HeightStroke implements TerrainStroke {
    /** Smoothing takes the mean over a square whose half side is this fraction of the radius. */
    private static final double MEAN_PER_RADIUS = 0.25;
    /** Means of values over rectangles of samples, from sums over all rectangles that begin at a corner (Crow 1984). */
    private static final class BoxMean {
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

    private final TerrainBrush brush;
    private final TerrainGrid grid;
    private final double radius;
    private final Terrain.HeightRange range;
    private final HeightMap before;
    private final double lowMetres;
    private final double metresPerUnit;
    private final float[] values;
    private final Dabs dabs;
    private final float flat;
    private HeightMap map;
    /** What {@link #map} does not show yet; {@code null} for nothing. */
    private SampleRange unshown;

    private boolean isAtLimit;

    /**
     * Begins a stroke with its first dab.
     *
     * @param authored has heights of more than one value
     * @param map its heights
     */
    public HeightStroke(Terrain authored, HeightMap map, TerrainBrush brush, double x, double z) {
        this.brush = brush;
        this.map = map;
        before = map;
        range = authored.heightRangeMetres();
        grid = TerrainGrid.of(authored, map.columns(), map.rows());
        radius = grid.effective(brush.radiusMetres());
        lowMetres = range.low();
        metresPerUnit = (range.high() - range.low()) / HeightMap.FULL_SCALE;
        values = new float[map.values().length];
        for (int i = 0; i < values.length; i++) {
            values[i] = map.values()[i] & 0xffff;
        }
        flat = (float) valueAt(x, z);
        dabs = new Dabs(authored, radius / 4, radius, x, z);
        dab(x, z);
    }

    @Override
    public void to(double x, double z) {
        dabs.to(x, z, this::dab);
    }

    /** Returns the heights now; an object that was returned before does not change. */
    public HeightMap map() {
        if (unshown != null) {
            map = rounded(unshown);
            unshown = null;
        }
        return map;
    }

    /** Returns true if the map's range has ended the raising or lowering of a height. */
    public boolean isAtLimit() {
        return isAtLimit;
    }

    /** Returns the height of a place above the terrain's centre, that of the border beside the map. */
    double heightMetres(double x, double z) {
        return lowMetres + metresPerUnit * valueAt(x, z);
    }

    @Override
    public boolean isTouched() {
        return map() != before;
    }

    @Override
    public boolean isChange() {
        return !Arrays.equals(before.values(), map().values());
    }

    @Override
    public PaintedMaps.PaintedMap painted() {
        return PaintedMaps.PaintedMap.of(map());
    }

    @Override
    public Terrain on(Terrain authored, String file) {
        return authored.withHeightMap(file);
    }

    @Override
    public String name(Terrain authored) {
        return authored.id();
    }

    @Override
    public OptionalDouble height(double x, double z) {
        return OptionalDouble.of(heightMetres(x, z));
    }

    @Override
    public Optional<Words> notice() {
        return isAtLimit
                ? Optional.of(TerrainText.AT_LIMIT.with(
                        TerrainText.number(Math.min(range.low(), range.high())),
                        TerrainText.number(Math.max(range.low(), range.high()))))
                : Optional.empty();
    }

    @Override
    public Optional<Words> objection() {
        return Optional.empty();
    }

    private void dab(double x, double z) {
        SampleRange part = grid.around(x, z, radius);
        if (part.isEmpty()) {
            return;
        }
        BoxMean mean = brush.effect() == Effect.SMOOTH ? mean(part) : null;
        for (int row = part.firstRow(); row <= part.lastRow(); row++) {
            for (int column = part.firstColumn(); column <= part.lastColumn(); column++) {
                double weight = TerrainBrush.falloff(grid.fractionSquared(column, row, x, z, radius));
                int at = row * grid.columns() + column;
                double value = values[at] + change(at, weight, mean == null ? 0 : mean.around(column, row));
                isAtLimit |= value < 0 || value > HeightMap.FULL_SCALE;
                values[at] = (float) Math.max(0, Math.min(value, HeightMap.FULL_SCALE));
            }
        }
        unshown = unshown == null ? part : unshown.union(part);
    }

    private double change(int at, double weight, double mean) {
        return switch (brush.effect()) {
            case RAISE -> weight * brush.riseMetres() / metresPerUnit;
            case LOWER -> -weight * brush.riseMetres() / metresPerUnit;
            case SMOOTH -> weight * brush.strength() * (mean - values[at]);
            case FLATTEN -> weight * brush.strength() * (flat - values[at]);
            case PAINT, ERASE -> 0;
        };
    }

    private BoxMean mean(SampleRange part) {
        int halfColumns = (int) Math.max(1, Math.round(MEAN_PER_RADIUS * radius / grid.cellX()));
        int halfRows = (int) Math.max(1, Math.round(MEAN_PER_RADIUS * radius / grid.cellZ()));
        return new BoxMean(values, grid, grid.grown(part, halfColumns, halfRows), halfColumns, halfRows);
    }

    private HeightMap rounded(SampleRange part) {
        short[] rounded = map.values().clone();
        for (int row = part.firstRow(); row <= part.lastRow(); row++) {
            for (int column = part.firstColumn(); column <= part.lastColumn(); column++) {
                int at = row * grid.columns() + column;
                rounded[at] = (short) Math.round(values[at]);
            }
        }
        return new HeightMap(map.columns(), map.rows(), 16, rounded);
    }

    /** Returns the value between the samples at a place, that of the border beside the map. */
    private double valueAt(double x, double z) {
        double across = Math.max(0, Math.min((x - grid.leastX()) / grid.cellX(), grid.columns() - 1));
        double along = Math.max(0, Math.min((z - grid.leastZ()) / grid.cellZ(), grid.rows() - 1));
        int column = Math.min((int) across, grid.columns() - 2);
        int row = Math.min((int) along, grid.rows() - 2);
        double u = across - column;
        double v = along - row;
        int at = row * grid.columns() + column;
        double near = values[at] + u * (values[at + 1] - values[at]);
        int next = at + grid.columns();
        double far = values[next] + u * (values[next + 1] - values[next]);
        return near + v * (far - near);
    }
}
