package nephele.engine.math.heightfield;

import java.util.Optional;
import java.util.stream.IntStream;
import nephele.engine.math.heightfield.HeightFieldDetail.Tiles;

/**
 * How far coarser triangles of a {@link HeightField} are from its own. Level l keeps every 2ˡ-th sample and cuts its cells
 * along the same diagonal. Tiles of level l have {@link #TILE_CELLS} cells of that level along a side; each level's are
 * twice as wide as those of the level below, up to one that covers the field. Immutable.
 *
 * <p>All distances are vertical. Both surfaces are linear between the samples of the finer one, which has the coarser
 * one's diagonals among its own, so the greatest distance is at a sample.
 */
public final class HeightFieldDetail {
    /** Cells along a side of a tile. */
    public static final int TILE_CELLS = 8;

    private final HeightField field;
    private final Tiles[] levels;

    /**
     * The tiles of one level in row-major order, all lengths in metres.
     *
     * @param error greatest distance of the level's triangles from those of the field
     * @param coarserError the same for the next coarser level; infinite if the field ends within a cell of that level
     * @param step greatest height of a sample of this level above or below the next coarser level's triangles
     * @param spread greatest distance of two points of the surface above a cell of the next coarser level
     * @param rise greatest rise of the smooth surface along x or z, up or down, metres a metre
     */
    record Tiles(
            int columns, int rows, float[] error, float[] coarserError, float[] step, float[] spread, float[] rise) {
        /** Returns a copy of what is measured; the rest is gathered from the finer level. */
        Tiles copy(int level) {
            float[] rises = level == 0 ? rise.clone() : new float[rise.length];
            return new Tiles(
                    columns, rows, new float[error.length], coarserError.clone(), step.clone(), spread.clone(), rises);
        }

        static Tiles empty(int columns, int rows) {
            int count = columns * rows;
            return new Tiles(
                    columns,
                    rows,
                    new float[count],
                    new float[count],
                    new float[count],
                    new float[count],
                    new float[count]);
        }
    }

    private HeightFieldDetail(HeightField field, Tiles[] levels) {
        this.field = field;
        this.levels = levels;
    }

    /** Measures all levels of a field: every sample once for each level. */
    public static HeightFieldDetail of(HeightField field) {
        int cells = Math.max(field.cellColumns(), field.cellRows());
        int top = 0;
        while (TILE_CELLS << top < cells) {
            top++;
        }
        Tiles[] levels = new Tiles[top + 1];
        for (int level = 0; level <= top; level++) {
            Tiles tiles = Tiles.empty(tiles(field.cellColumns(), level), tiles(field.cellRows(), level));
            levels[level] = tiles;
            if (level > 0) {
                gather(levels[level - 1], tiles);
            }
            if (isMeasured(level, top)) {
                int its = level;
                IntStream.range(0, tiles.rows()).parallel().forEach(row -> new DetailMeasure(field, its, tiles)
                        .measureRow(row));
            }
        }
        return new HeightFieldDetail(field, levels);
    }

    /** Measures a field of which another's levels are known: only the tiles with different heights. */
    public static HeightFieldDetail edited(HeightFieldDetail before, HeightField field) {
        Optional<SampleRange> changed = field.difference(before.field);
        if (changed.isEmpty()) {
            return of(field);
        }
        Tiles[] levels = new Tiles[before.levels.length];
        for (int level = 0; level < levels.length; level++) {
            levels[level] = before.levels[level].copy(level);
            if (level > 0) {
                gather(levels[level - 1], levels[level]);
            }
            if (isMeasured(level, levels.length - 1)) {
                remeasure(new DetailMeasure(field, level, levels[level]), changed.get(), TILE_CELLS << level);
            }
        }
        return new HeightFieldDetail(field, levels);
    }

    /** Returns whether heights of the field are read: for the next coarser level, and the finest one for rises. */
    private static boolean isMeasured(int level, int top) {
        return level < top || level == 0;
    }

    /**
     * Measures the tiles whose samples, or those beside them, which the rises need, have changed.
     *
     * @param width cells of a tile along a side; neighbours share the samples of their border
     */
    private static void remeasure(DetailMeasure measure, SampleRange changed, int width) {
        if (!changed.isEmpty()) {
            int firstRow = Math.max(0, (changed.firstRow() - 2) / width);
            int firstColumn = Math.max(0, (changed.firstColumn() - 2) / width);
            for (int row = firstRow; row <= (changed.lastRow() + 1) / width; row++) {
                for (int column = firstColumn; column <= (changed.lastColumn() + 1) / width; column++) {
                    measure.measureIfThere(column, row);
                }
            }
        }
    }

    private static int tiles(int cells, int level) {
        int width = TILE_CELLS << level;
        return (cells + width - 1) / width;
    }

    private static void gather(Tiles finer, Tiles tiles) {
        for (int row = 0; row < finer.rows(); row++) {
            for (int column = 0; column < finer.columns(); column++) {
                int part = row * finer.columns() + column;
                int at = row / 2 * tiles.columns() + column / 2;
                tiles.error()[at] = Math.max(tiles.error()[at], finer.coarserError()[part]);
                tiles.rise()[at] = Math.max(tiles.rise()[at], finer.rise()[part]);
            }
        }
    }

    /** Returns the field. */
    public HeightField field() {
        return field;
    }

    /** Returns the level of the one tile that covers the field; level 0 has all samples. */
    public int top() {
        return levels.length - 1;
    }

    /** Returns the greatest distance of a tile's triangles from those of the field, metres. */
    public double error(int level, int column, int row) {
        return levels[level].error()[row * levels[level].columns() + column];
    }

    /** Returns the greatest rise of the smooth surface over a tile along x or z, up or down, metres a metre. */
    float rise(int level, int column, int row) {
        return levels[level].rise()[row * levels[level].columns() + column];
    }

    Tiles tiles(int level) {
        return levels[level];
    }

    /** Measures the tiles of one level of a {@link HeightFieldDetail} against the next coarser level. */
    private static final class DetailMeasure {
        private final HeightField field;
        private final Tiles tiles;
        /** Columns between samples of the level, and of the next coarser one. */
        private final int fine;

        private final int coarse;
        private double error;
        private double step;
        private double least;
        private double greatest;

        DetailMeasure(HeightField field, int level, Tiles tiles) {
            this.field = field;
            this.tiles = tiles;
            fine = 1 << level;
            coarse = 2 << level;
        }

        void measureRow(int row) {
            for (int column = 0; column < tiles.columns(); column++) {
                measure(column, row);
            }
        }

        /** Measures a tile; the last samples of a field may begin a tile that does not exist. */
        void measureIfThere(int column, int row) {
            if (column < tiles.columns() && row < tiles.rows()) {
                measure(column, row);
            }
        }

        private void measure(int column, int row) {
            int at = row * tiles.columns() + column;
            int width = HeightFieldDetail.TILE_CELLS * fine;
            int endColumn = Math.min((column + 1) * width, field.cellColumns());
            int endRow = Math.min((row + 1) * width, field.cellRows());
            if (fine == 1) {
                tiles.rise()[at] = upwards(rise(column * width, row * width, endColumn, endRow));
            }
            if (endColumn % coarse != 0 || endRow % coarse != 0) {
                tiles.coarserError()[at] = Float.POSITIVE_INFINITY;
                return;
            }
            error = 0;
            step = 0;
            double relief = 0;
            for (int z = row * width; z < endRow; z += coarse) {
                for (int x = column * width; x < endColumn; x += coarse) {
                    measureCell(x, z);
                    relief = Math.max(relief, greatest - least);
                }
            }
            tiles.coarserError()[at] = upwards(error);
            tiles.step()[at] = upwards(step);
            tiles.spread()[at] = upwards(
                    Math.sqrt(square(coarse * field.cellX()) + square(coarse * field.cellZ()) + square(relief)));
        }

        private double rise(int column, int row, int endColumn, int endRow) {
            double most = 0;
            for (int z = row; z <= endRow; z++) {
                for (int x = column; x <= endColumn; x++) {
                    double alongX = Math.abs(HeightFieldSurface.riseAlongX(field, x, z));
                    most = Math.max(most, Math.max(alongX, Math.abs(HeightFieldSurface.riseAlongZ(field, x, z))));
                }
            }
            return most;
        }

        private void measureCell(int x, int z) {
            double h00 = field.height(x, z);
            double h10 = field.height(x + coarse, z);
            double h01 = field.height(x, z + coarse);
            double h11 = field.height(x + coarse, z + coarse);
            least = h00;
            greatest = h00;
            double most = error;
            for (int v = 0; v <= coarse; v++) {
                double fraction = (double) v / coarse;
                double alongDiagonal = h00 + fraction * (h11 - h00);
                double left = h00 + fraction * (h01 - h00);
                double right = h10 + fraction * (h11 - h10);
                double before = v == 0 ? 0 : (alongDiagonal - left) / v;
                double after = v == coarse ? 0 : (right - alongDiagonal) / (coarse - v);
                for (int u = 0; u <= coarse; u++) {
                    double height = field.height(x + u, z + v);
                    double coarser = alongDiagonal + (u - v) * (u <= v ? before : after);
                    double off = Math.abs(height - coarser);
                    least = Math.min(least, height);
                    greatest = Math.max(greatest, height);
                    most = Math.max(most, off);
                    if (off > step && u % fine == 0 && v % fine == 0) {
                        step = off;
                    }
                }
            }
            error = most;
        }

        /** Returns a float that is not less, with a margin for the rounding of interpolations. */
        private static float upwards(double metres) {
            return Math.nextUp((float) (metres * (1 + 1e-9)));
        }

        private static double square(double x) {
            return x * x;
        }
    }
}
