package nephele.engine.cloud.drawn;

import java.util.stream.IntStream;
import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.cells.DensityCells;

/**
 * The columns of a box of a cloud that is drawn as a sheet: the mean density of each, and its products with the mean height and
 * the mean square of the height, 0 at the base and 1 at the top; x fastest. Columns are finer than cells.
 *
 * @param values {@value #VALUES} a column, the last of which is 0
 */
public record SheetColumns(int nx, int nz, float[] values) {
    public static final int VALUES = 4;

    /** Columns along the edge of a cell. */
    public static final int PER_CELL = 4;

    private static final int ROWS = 8;

    /** @param fullPerMetre extinction that density 1 stands for */
    static SheetColumns of(DensityCells.Columns field, CellBox cells, double fullPerMetre) {
        var fine = new CellBox(cells.box(), PER_CELL * cells.nx(), Math.min(cells.ny(), ROWS), PER_CELL * cells.nz());
        double[] least = new double[fine.ny()];
        for (int j = 0; j < least.length; j++) {
            least[j] = field.leastDepth(fine.centreY(j), fine.centreY(j));
        }
        float[] values = new float[VALUES * fine.nx() * fine.nz()];
        double scale = fullPerMetre > 0 ? 1 / (fullPerMetre * fine.ny()) : 0;
        IntStream.range(0, fine.nz()).parallel().forEach(k -> {
            double[] rows = new double[fine.ny()];
            for (int i = 0; i < fine.nx(); i++) {
                double x = fine.centreX(i);
                double z = fine.centreZ(k);
                double depth = field.depth(x, z);
                for (int j = 0; j < rows.length; j++) {
                    rows[j] = depth > least[j] ? field.perMetre(depth, x, fine.centreY(j), z) : 0;
                }
                put(rows, scale, values, VALUES * (k * fine.nx() + i));
            }
        });
        return new SheetColumns(fine.nx(), fine.nz(), values);
    }

    private static void put(double[] rows, double scale, float[] values, int at) {
        double within = 1.0 / (12.0 * rows.length * rows.length);
        double sum = 0;
        double first = 0;
        double second = 0;
        for (int j = 0; j < rows.length; j++) {
            double height = (j + 0.5) / rows.length;
            sum += rows[j];
            first += rows[j] * height;
            second += rows[j] * (height * height + within);
        }
        values[at] = (float) (scale * sum);
        values[at + 1] = (float) (scale * first);
        values[at + 2] = (float) (scale * second);
    }
}
