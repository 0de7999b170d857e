package nephele.engine.math.heightfield;

import java.util.Arrays;
import nephele.engine.math.Frustum;

/** The tiles of a {@link HeightFieldDetail} that a view draws, the nearer ones first. Refilled for each view. */
public final class DetailTiles {
    /**
     * Floats of each tile: its first column and row, columns between its samples, its level, then the ranges at its
     * corners: at least x and z, greatest x, greatest z, greatest both.
     */
    public static final int FLOATS = 8;

    private final double[] bounds = new double[6];
    private float[] values = new float[FLOATS * 256];
    private float[] rises = new float[256];
    private int count;
    private DetailRanges ranges;
    private DetailView view;
    private Frustum frustum;

    /** Selects the coarsest tiles that are fine enough, among those that a frustum may contain. */
    public void select(DetailRanges allowed, DetailView newView, Frustum newFrustum) {
        ranges = allowed;
        view = newView;
        frustum = newFrustum;
        count = 0;
        select(allowed.detail().top(), 0, 0);
    }

    private void select(int level, int column, int row) {
        HeightField field = ranges.detail().field();
        writeBounds(field, level, column, row, bounds);
        if (frustum.classify(bounds, 0, frustum.allPlanes()) == Frustum.OUTSIDE) {
            return;
        }
        if (level == 0 || view.leastRange(bounds) >= ranges.finerRange(level, column, row)) {
            add(level, column, row);
            return;
        }
        int nearX = view.eye().x() > (bounds[0] + bounds[3]) / 2 ? 1 : 0;
        int nearZ = view.eye().z() > (bounds[2] + bounds[5]) / 2 ? 1 : 0;
        int width = HeightFieldDetail.TILE_CELLS << level - 1;
        for (int part = 0; part < 4; part++) {
            int x = 2 * column + (part & 1 ^ nearX);
            int z = 2 * row + (part >> 1 ^ nearZ);
            if (x * width < field.cellColumns() && z * width < field.cellRows()) {
                select(level - 1, x, z);
            }
        }
    }

    private void add(int level, int column, int row) {
        int at = FLOATS * count++;
        if (at == values.length) {
            values = Arrays.copyOf(values, 2 * values.length);
            rises = Arrays.copyOf(rises, 2 * rises.length);
        }
        rises[at / FLOATS] = ranges.detail().rise(level, column, row);
        values[at] = column * (HeightFieldDetail.TILE_CELLS << level);
        values[at + 1] = row * (HeightFieldDetail.TILE_CELLS << level);
        values[at + 2] = 1 << level;
        values[at + 3] = level;
        ranges.writeCorners(level, column, row, values, at + 4);
    }

    /** Returns the number of tiles. */
    public int count() {
        return count;
    }

    /** Returns the tiles, {@link #FLOATS} each; beyond {@link #count} they are old. */
    public float[] values() {
        return values;
    }

    /** Returns the greatest rise of the smooth surface over a tile along x or z, up or down, metres a metre. */
    public float rise(int tile) {
        return rises[tile];
    }

    static void writeBounds(HeightField field, int level, int column, int row, double[] bounds) {
        field.writeBlock(field.blockLevel(HeightFieldDetail.TILE_CELLS << level), column, row, bounds);
    }

    static double diagonal(double[] box) {
        double x = box[3] - box[0];
        double y = box[4] - box[1];
        double z = box[5] - box[2];
        return Math.sqrt(x * x + y * y + z * z);
    }
}
