package nephele.engine.cloud.cells;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.appearance.CloudDemand;
import nephele.engine.math.Aabb;

/**
 * The lattice of a layer's cells: boxes of the layer's heights around a focus, each {@link CellStack#WIDENING} times as
 * wide as the one before. A box moves by whole blocks of its cells, so that a cell has the same place and value in every
 * box that contains it.
 *
 * @param cellMetres width of a cell of the narrowest box
 * @param rows cells from base to top
 * @param across cells of a box along x and z
 * @param reach a box is used up to this distance from the focus, in its cells; the next wider one from there on
 */
public record LayerGrid(
        double baseMetres, double topMetres, double cellMetres, int rows, int levels, int across, int reach) {
    /** The width of a cloud's boxes. */
    static final int ACROSS = CloudDemand.LAYER_ACROSS;
    /** Reach of a cloud's boxes, in their cells: rays towards the sun begin in a box and go on in it for a while. */
    static final int REACH = 18;
    /** How far the focus may be from a box's middle, in its cells. */
    static final int SLACK = 6;
    /** How far depths are summed in a box before the next wider one, in its cells. */
    static final int WALK = ACROSS / 2 - REACH - SLACK;
    /** The number of cells by which a box moves at once. */
    private static final int BLOCK = 8;

    /** The middle of a box, in blocks of its cells. */
    public record Column(long x, long z) {}

    /** Returns the lattice of a cloud. */
    public static LayerGrid ofCloud(double baseMetres, double topMetres, double cellMetres, int rows, int levels) {
        return new LayerGrid(baseMetres, topMetres, cellMetres, rows, levels, ACROSS, REACH);
    }

    /** Returns the middles of boxes nearest to a focus. */
    public List<Column> around(double x, double z) {
        List<Column> columns = new ArrayList<>();
        for (int level = 0; level < levels; level++) {
            columns.add(nearest(level, x, z));
        }
        return columns;
    }

    /** Returns the same middles, but the nearest one for each that is farther from a focus than so many cells. */
    public List<Column> following(List<Column> columns, double x, double z, double cells) {
        List<Column> moved = new ArrayList<>();
        for (int level = 0; level < levels; level++) {
            Column column = columns.get(level);
            moved.add(distance(level, column, x, z) <= cells ? column : nearest(level, x, z));
        }
        return moved;
    }

    /** Returns true if boxes with these middles serve a focus. */
    public boolean covers(List<Column> columns, double x, double z) {
        for (int level = 0; level < levels; level++) {
            if (!(distance(level, columns.get(level), x, z) <= SLACK)) {
                return false;
            }
        }
        return true;
    }

    /** Returns the box of a middle. */
    public CellBox box(int level, Column column) {
        double middleX = column.x() * block(level);
        double middleZ = column.z() * block(level);
        double half = across / 2 * cell(level);
        return new CellBox(
                new Aabb(middleX - half, baseMetres, middleZ - half, middleX + half, topMetres, middleZ + half),
                across,
                rows,
                across);
    }

    private Column nearest(int level, double x, double z) {
        return new Column(Math.round(x / block(level)), Math.round(z / block(level)));
    }

    private double distance(int level, Column column, double x, double z) {
        return Math.max(Math.abs(x - column.x() * block(level)), Math.abs(z - column.z() * block(level))) / cell(level);
    }

    private double cell(int level) {
        return cellMetres * Math.pow(CellStack.WIDENING, level);
    }

    private double block(int level) {
        return BLOCK * cell(level);
    }
}
