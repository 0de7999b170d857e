package nephele.engine.math.heightfield;

import nephele.engine.math.heightfield.HeightFieldDetail.Tiles;

/** Measures the tiles of one level of a {@link HeightFieldDetail} against the next coarser level. */
final class DetailMeasure {
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
        tiles.spread()[at] =
                upwards(Math.sqrt(square(coarse * field.cellX()) + square(coarse * field.cellZ()) + square(relief)));
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
            double share = (double) v / coarse;
            double alongDiagonal = h00 + share * (h11 - h00);
            double left = h00 + share * (h01 - h00);
            double right = h10 + share * (h11 - h10);
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
