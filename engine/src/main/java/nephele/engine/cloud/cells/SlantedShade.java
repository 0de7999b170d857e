package nephele.engine.cloud.cells;

import java.nio.ShortBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.math.Vec3;

/**
 * The fraction of a distant light that clouds take on its way to places, in nested boxes. A place is found by where the
 * light's ray to it crosses the base of the clouds, and by its height: all places of a ray below the clouds have one
 * value, however far below they are. The centres of the lowest cells are at the base, those of the highest at the top.
 * Immutable.
 */
public final class SlantedShade {
    /** The light goes along by no more than this cotangent of its elevation for each metre of height. */
    private static final double MOST_SLANT = 50;

    private static final int ACROSS = 128;
    private static final int REACH = ACROSS / 2 - LayerGrid.SLACK - 2;

    private static final double STEP_METRES = 50;
    /** Greatest number of steps from a row to the next. */
    private static final int MOST_STEPS = 12;

    private final List<CellBox> boxes;
    private final List<float[]> taken;

    private SlantedShade(List<CellBox> boxes, List<float[]> taken) {
        this.boxes = List.copyOf(boxes);
        this.taken = taken;
    }

    /** Returns the lattice for clouds between two heights. */
    public static LayerGrid grid(double baseMetres, double topMetres, double cellMetres, int rows, int levels) {
        double halfRow = 0.5 * (topMetres - baseMetres) / (rows - 1);
        return new LayerGrid(baseMetres - halfRow, topMetres + halfRow, cellMetres, rows, levels, ACROSS, REACH);
    }

    /**
     * Returns how far a light goes along x and z, in y nothing, for each metre that it comes down.
     *
     * @param towardsLight unit
     */
    public static Vec3 slant(Vec3 towardsLight) {
        double level = Math.hypot(towardsLight.x(), towardsLight.z());
        double cotangent = level / Math.max(towardsLight.y(), level / MOST_SLANT);
        return level == 0
                ? Vec3.ZERO
                : new Vec3(cotangent * towardsLight.x() / level, 0, cotangent * towardsLight.z() / level);
    }

    /**
     * A cloud that casts shade.
     *
     * @param field in its own space
     * @param shift from places of the lattice to those of its space
     * @param fraction of its extinction that its weather gives it
     */
    public record Caster(ExtinctionField field, Vec3 shift, double fraction) {
        double perMetre(double x, double y, double z) {
            return fraction * field.perMetre(x + shift.x(), y + shift.y(), z + shift.z());
        }
    }

    /**
     * Computes the shade on all processors.
     *
     * @param columns middles of the boxes of {@link #grid}
     * @param towardsLight unit
     */
    public static SlantedShade of(
            LayerGrid grid, List<LayerGrid.Column> columns, List<Caster> casters, Vec3 towardsLight) {
        Vec3 slant = slant(towardsLight);
        List<CellBox> boxes = new ArrayList<>();
        List<float[]> taken = new ArrayList<>();
        for (int level = 0; level < grid.levels(); level++) {
            CellBox cells = grid.box(level, columns.get(level));
            float[] values = new float[cells.count()];
            IntStream.range(0, cells.nz()).parallel().forEach(k -> {
                for (int i = 0; i < cells.nx(); i++) {
                    fillColumn(cells, i, k, casters, slant, values);
                }
            });
            boxes.add(cells);
            taken.add(values);
        }
        return new SlantedShade(boxes, taken);
    }

    /** Follows a ray of the light down: all places of a column are on it. */
    private static void fillColumn(CellBox cells, int i, int k, List<Caster> casters, Vec3 slant, float[] values) {
        double pathOfRow = cells.sizeY() * Math.sqrt(1 + slant.dot(slant));
        int steps = (int) Math.max(1, Math.min(MOST_STEPS, Math.ceil(pathOfRow / STEP_METRES)));
        double depth = 0;
        for (int j = cells.ny() - 1; j >= 0; j--) {
            for (int step = 0; step < steps && j < cells.ny() - 1; step++) {
                double over = (j + (step + 0.5) / steps) * cells.sizeY();
                double x = cells.centreX(i) + over * slant.x();
                double y = cells.centreY(0) + over;
                double z = cells.centreZ(k) + over * slant.z();
                for (Caster caster : casters) {
                    depth += caster.perMetre(x, y, z) * pathOfRow / steps;
                }
            }
            values[cells.index(i, j, k)] = (float) -Math.expm1(-depth);
        }
    }

    /** Returns the boxes, the narrowest first. */
    public List<CellBox> boxes() {
        return boxes;
    }

    /** Puts a slice of equal z of a box as unsigned 16 bits, x fastest: this time's fraction, then another time's. */
    public void put(SlantedShade next, int level, int k, ShortBuffer texels) {
        CellBox cells = boxes.get(level);
        int first = cells.index(0, 0, k);
        for (int at = first; at < first + cells.nx() * cells.ny(); at++) {
            texels.put((short) Math.round(65535 * taken.get(level)[at]))
                    .put((short) Math.round(65535 * next.taken.get(level)[at]));
        }
    }
}
