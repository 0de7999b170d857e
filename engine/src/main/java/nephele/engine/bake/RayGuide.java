package nephele.engine.bake;

import java.util.Arrays;
import nephele.engine.scene.light.bake.LightMapChart;

/**
 * The directions from which light comes to a square of texels of one chart, learned from the links of all of them. Most
 * rays of a gather leave in these directions, so that a door or a patch of sun that few even rays would meet is neither
 * missed nor noisy (after Müller, Gross and Novák 2017, "Practical Path Guiding", with one fixed grid over the unit square
 * from which Malley's method draws directions). Vertices and terrains have even rays.
 */
final class RayGuide {
    /** Texels along a side of the square. */
    private static final int SQUARE_TEXELS = 8;

    /** Cells of the grid along each of its sides. */
    private static final int SIDE = 8;

    private static final int CELLS = SIDE * SIDE;

    /** The share of even rays: no weight of a ray is greater than its inverse. */
    private static final double EVEN = 0.4;

    private static final double BELOW_ONE = Math.nextDown(1.0);

    /** The positive root of x³ = x + 1; its powers are the least rational steps in two dimensions (Roberts 2018). */
    private static final double STEP_ROOT = 1.32471795724474602596;

    /** The square of each receiver; −1 for one without. */
    private final int[] squareOf;
    /** For each square and cell first the sum of squares of luminance, at last the density, 1 in the mean. */
    private final double[] cells;

    private final int[] counts;

    /**
     * A point of the unit square from which a direction is drawn.
     *
     * @param weight the inverse of its density
     */
    record Aim(double u, double v, double weight) {
        /** Returns a ray's point in a sequence of points that fill the square evenly, moved by some random bits. */
        static Aim even(long shift, int ray) {
            double u = fraction((shift >>> 11) * 0x1p-53 + ray / STEP_ROOT);
            double v = fraction((shift << 32 >>> 11) * 0x1p-53 + ray / (STEP_ROOT * STEP_ROOT));
            return new Aim(u, v, 1);
        }

        private static double fraction(double x) {
            return x - Math.floor(x);
        }
    }

    RayGuide(Receivers receivers) {
        squareOf = new int[receivers.count()];
        Arrays.fill(squareOf, -1);
        int squares = 0;
        for (int chart = 0; chart < receivers.layout().charts().size(); chart++) {
            LightMapChart texels = receivers.layout().charts().get(chart);
            int across = (texels.columns() + SQUARE_TEXELS - 1) / SQUARE_TEXELS;
            for (int i = 0; i < texels.columns() * texels.rows(); i++) {
                int column = i % texels.columns() / SQUARE_TEXELS;
                int row = i / texels.columns() / SQUARE_TEXELS;
                squareOf[receivers.firstOfChart(chart) + i] = squares + row * across + column;
            }
            squares += across * ((texels.rows() + SQUARE_TEXELS - 1) / SQUARE_TEXELS);
        }
        cells = new double[CELLS * squares];
        counts = new int[cells.length];
    }

    /** Adds the luminance that an even ray met to its cell. */
    void learn(int receiver, Aim aim, double luminance) {
        if (squareOf[receiver] >= 0) {
            int cell = CELLS * squareOf[receiver] + SIDE * (int) (SIDE * aim.u()) + (int) (SIDE * aim.v());
            cells[cell] += luminance * luminance;
            counts[cell]++;
        }
    }

    /** Ends learning: a cell's density follows the root mean square of what was met there. */
    void finish() {
        for (int first = 0; first < cells.length; first += CELLS) {
            double sum = 0;
            for (int i = first; i < first + CELLS; i++) {
                cells[i] = Math.sqrt(cells[i] / Math.max(1, counts[i]));
                sum += cells[i];
            }
            for (int i = first; i < first + CELLS; i++) {
                cells[i] = sum > 0 ? EVEN + (1 - EVEN) * CELLS * cells[i] / sum : 1;
            }
        }
    }

    /** Returns the point of an even ray, moved so that points are as dense as the cells of the receiver's square say. */
    Aim guided(int receiver, Aim even) {
        if (squareOf[receiver] < 0) {
            return even;
        }
        int row = CELLS * squareOf[receiver];
        double left = CELLS * even.u();
        double sum = rowSum(row);
        int i = 0;
        for (; i < SIDE - 1 && left >= sum; i++) {
            left -= sum;
            row += SIDE;
            sum = rowSum(row);
        }
        double along = sum * even.v();
        int j = 0;
        for (; j < SIDE - 1 && along >= cells[row + j]; j++) {
            along -= cells[row + j];
        }
        double u = (i + Math.min(left / sum, BELOW_ONE)) / SIDE;
        double v = (j + Math.min(along / cells[row + j], BELOW_ONE)) / SIDE;
        return new Aim(Math.min(u, BELOW_ONE), Math.min(v, BELOW_ONE), 1 / cells[row + j]);
    }

    private double rowSum(int row) {
        double sum = 0;
        for (int i = row; i < row + SIDE; i++) {
            sum += cells[i];
        }
        return sum;
    }
}
