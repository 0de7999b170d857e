package nephele.engine.math.heightfield;

import java.util.Optional;
import java.util.function.IntConsumer;
import nephele.engine.math.Aabb;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.RayTriangleIntersection;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.BoxTest;
import nephele.engine.math.bvh.ItemRayTest;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.bvh.SweptAabb;

/**
 * A surface over a regular grid of heights, which are stored as floats. Each cell is split into two triangles along the diagonal from its corner of
 * least x and z to that of greatest x and z. Cells and triangles are not stored; they are computed, and found through a
 * min-max pyramid of the heights. Triangle 2 (row · cells per row + column) is the half of a cell with the greater z,
 * the next number the half with the greater x; their front faces point up. Immutable and thread-safe.
 */
public final class HeightField {
    /** The maximum number of samples along a side. */
    public static final int MOST_SAMPLES = 8193;

    /** A descending ray that starts at most this far below a triangle counts as starting on it. */
    private static final double ON_SURFACE_METRES = 1e-9;

    /** About ninety ε. */
    private static final double RELATIVE_ROUNDING = 1e-14;

    /** The least edge length of a cell. */
    public static final double LEAST_CELL_METRES = 1e-3;

    private static final double FARTHEST_METRES = 1e7;

    private final Vec3 origin;
    private final double cellX;
    private final double cellZ;
    private final int columns;
    private final int rows;
    private final float[] heights;
    private final MinMaxPyramid pyramid;

    /** A function that returns the height of each sample, in metres above the origin. */
    @FunctionalInterface
    public interface Heights {
        double metres(int column, int row);
    }

    private HeightField(Vec3 origin, double cellX, double cellZ, int columns, int rows, Heights source) {
        this.origin = origin;
        this.cellX = cellX;
        this.cellZ = cellZ;
        this.columns = columns;
        this.rows = rows;
        heights = heights(columns, rows, source);
        pyramid = new MinMaxPyramid(heights, columns, rows);
    }

    private static float[] heights(int columns, int rows, Heights source) {
        float[] heights = new float[columns * rows];
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                heights[row * columns + column] = (float) checked(source.metres(column, row), column, row);
            }
        }
        return heights;
    }

    /** Creates a height field with square cells, as {@link #of(Vec3, double, double, int, int, Heights)} does. */
    public static HeightField of(Vec3 origin, double cellMetres, int columns, int rows, Heights source) {
        return of(origin, cellMetres, cellMetres, columns, rows, source);
    }

    /**
     * Creates a height field.
     *
     * @param origin position of the sample at column 0 and row 0 for height 0; columns run along x, rows along z
     * @param cellX edge length of a cell along x in metres, 1e-3 to 1e7
     * @param cellZ the same along z
     * @param columns samples along x, 2 to {@link #MOST_SAMPLES}
     * @param rows samples along z, 2 to {@link #MOST_SAMPLES}
     * @param source called once for each sample; the result is rounded to a float
     * @throws IllegalArgumentException with the reason if the grid is too small or too large, extends beyond 1e7 m, or
     *     a height is NaN or beyond 1e7 m
     */
    public static HeightField of(Vec3 origin, double cellX, double cellZ, int columns, int rows, Heights source) {
        if (Math.min(columns, rows) < 2 || Math.max(columns, rows) > MOST_SAMPLES) {
            throw new IllegalArgumentException("a height field has 2 to " + MOST_SAMPLES
                    + " samples along each side, not " + columns + " × " + rows);
        }
        requireCell(cellX);
        requireCell(cellZ);
        requireNear(origin, (columns - 1) * cellX, (rows - 1) * cellZ);
        return new HeightField(origin, cellX, cellZ, columns, rows, source);
    }

    private HeightField(Vec3 origin, HeightField other, float[] heights, MinMaxPyramid pyramid) {
        this.origin = origin;
        cellX = other.cellX;
        cellZ = other.cellZ;
        columns = other.columns;
        rows = other.rows;
        this.heights = heights;
        this.pyramid = pyramid;
    }

    /**
     * Returns this field at another place; shares the heights.
     *
     * @throws IllegalArgumentException if it then extends beyond 1e7 m
     */
    public HeightField at(Vec3 place) {
        requireNear(place, (columns - 1) * cellX, (rows - 1) * cellZ);
        return new HeightField(place, this, heights, pyramid);
    }

    /**
     * Returns the field that {@link #of} makes of other heights over the same cells; its pyramid is found again only where
     * they differ.
     *
     * @throws IllegalArgumentException as {@link #of} does
     */
    public HeightField edited(Heights source) {
        float[] others = heights(columns, rows, source);
        SampleRange changed = SampleRange.differing(heights, others, columns);
        return changed.isEmpty()
                ? this
                : new HeightField(origin, this, others, pyramid.edited(others, columns, rows, changed));
    }

    private static void requireNear(Vec3 origin, double width, double depth) {
        double farthest = Math.max(
                Math.max(Math.abs(origin.x()), Math.abs(origin.x() + width)),
                Math.max(Math.abs(origin.z()), Math.abs(origin.z() + depth)));
        if (!(Math.max(farthest, Math.abs(origin.y())) <= FARTHEST_METRES)) {
            throw new IllegalArgumentException("a height field reaches no farther than " + FARTHEST_METRES
                    + " m from the world's origin; this one begins at x " + origin.x() + " m, y " + origin.y()
                    + " m, z " + origin.z() + " m");
        }
    }

    private static void requireCell(double metres) {
        if (!(metres >= LEAST_CELL_METRES && metres <= FARTHEST_METRES)) {
            throw new IllegalArgumentException("a height field's cells are " + LEAST_CELL_METRES + " m to "
                    + FARTHEST_METRES + " m wide, not " + metres + " m");
        }
    }

    private static double checked(double height, int column, int row) {
        if (!(Math.abs(height) <= FARTHEST_METRES)) {
            throw new IllegalArgumentException("the height at column " + column + ", row " + row + " is " + height
                    + ": heights are numbers of metres, at most " + FARTHEST_METRES + " above or below the origin");
        }
        return height;
    }

    /**
     * Returns a rectangle with all samples whose heights differ from those of another field; empty if the grids of the
     * two are of different sizes.
     */
    public Optional<SampleRange> difference(HeightField other) {
        if (columns != other.columns || rows != other.rows || cellX != other.cellX || cellZ != other.cellZ) {
            return Optional.empty();
        }
        return Optional.of(
                heights == other.heights ? SampleRange.NONE : SampleRange.differing(heights, other.heights, columns));
    }

    /** Returns the number of triangles, two for each cell. */
    public int triangles() {
        return 2 * (columns - 1) * (rows - 1);
    }

    /** Returns the position of the sample at column 0 and row 0 for height 0. */
    public Vec3 origin() {
        return origin;
    }

    /** Returns the edge length of a cell along x in metres. */
    public double cellX() {
        return cellX;
    }

    /** Returns the edge length of a cell along z in metres. */
    public double cellZ() {
        return cellZ;
    }

    /** Returns the number of cells along x, one less than that of samples. */
    public int cellColumns() {
        return columns - 1;
    }

    /** Returns the number of cells along z, one less than that of samples. */
    public int cellRows() {
        return rows - 1;
    }

    MinMaxPyramid pyramid() {
        return pyramid;
    }

    /** Returns the world x of a column. */
    public double x(int column) {
        return origin.x() + column * cellX;
    }

    /** Returns the world z of a row. */
    public double z(int row) {
        return origin.z() + row * cellZ;
    }

    /** Returns the world y of a height. */
    public double y(double height) {
        return origin.y() + height;
    }

    /** Returns the height of a sample in metres above the origin. */
    public float height(int column, int row) {
        return heights[row * columns + column];
    }

    /** Returns the least level of blocks, see {@link #writeBlock}, that are at least so many cells wide. */
    public int blockLevel(int cells) {
        int level = 0;
        while (MinMaxPyramid.BLOCK_CELLS << level < cells && level < pyramid.top()) {
            level++;
        }
        return level;
    }

    /**
     * Writes the bounds of a block of cells: three minima, three maxima. Blocks of level 0 are four cells wide, those of
     * each further level twice as wide.
     */
    public void writeBlock(int level, int column, int row, double[] bounds) {
        writeBlock(level, column, row, 0, bounds);
    }

    /** Writes a block's bounds, grown by a margin: three minima, three maxima. */
    void writeBlock(int level, int column, int row, double margin, double[] box) {
        box[0] = x(firstCell(column, level)) - margin;
        box[1] = y(pyramid.least(level, column, row)) - margin;
        box[2] = z(firstCell(row, level)) - margin;
        box[3] = x(endCell(column, level, cellColumns())) + margin;
        box[4] = y(pyramid.greatest(level, column, row)) + margin;
        box[5] = z(endCell(row, level, cellRows())) + margin;
    }

    /** Returns the first cell of a block along a side. */
    static int firstCell(int block, int level) {
        return block * (MinMaxPyramid.BLOCK_CELLS << level);
    }

    /** Returns one past the last cell of a block along a side with so many cells. */
    static int endCell(int block, int level, int cells) {
        return Math.min(firstCell(block + 1, level), cells);
    }

    /** Writes the bounds of half a cell, a triangle, grown by a margin: three minima, three maxima. */
    void writeTriangle(int column, int row, int half, double margin, double[] box) {
        double least = height(column, row);
        double greatest = height(column + 1, row + 1);
        double between = half == 0 ? height(column, row + 1) : height(column + 1, row);
        box[0] = x(column) - margin;
        box[1] = y(Math.min(between, Math.min(least, greatest))) - margin;
        box[2] = z(row) - margin;
        box[3] = x(column + 1) + margin;
        box[4] = y(Math.max(between, Math.max(least, greatest))) + margin;
        box[5] = z(row + 1) + margin;
    }

    /** Returns the number of the triangle that is a half of a cell. */
    int triangle(int column, int row, int half) {
        return 2 * (row * cellColumns() + column) + half;
    }

    /** Returns the number of blocks of a level along x. */
    public int blockColumns(int level) {
        return pyramid.columns(level);
    }

    /** Returns the number of blocks of a level along z. */
    public int blockRows(int level) {
        return pyramid.rows(level);
    }

    /** Returns the box that contains the whole field. */
    public Aabb bounds() {
        return new Aabb(
                x(0),
                y(pyramid.least(pyramid.top(), 0, 0)),
                z(0),
                x(columns - 1),
                y(pyramid.greatest(pyramid.top(), 0, 0)),
                z(rows - 1));
    }

    /**
     * Returns the position of corner 0 to 2, counter-clockwise seen from above; adjacent triangles share the bits of
     * their corners.
     */
    public Vec3 corner(int triangle, int corner) {
        int column = sampleColumn(triangle, corner);
        int row = sampleRow(triangle, corner);
        return new Vec3(x(column), y(height(column, row)), z(row));
    }

    private int sampleColumn(int triangle, int corner) {
        boolean isGreaterZ = (triangle & 1) == 0;
        return (triangle >> 1) % (columns - 1) + (corner == 0 || corner == 1 && isGreaterZ ? 0 : 1);
    }

    private int sampleRow(int triangle, int corner) {
        boolean isGreaterX = (triangle & 1) == 1;
        return (triangle >> 1) / (columns - 1) + (corner == 0 || corner == 2 && isGreaterX ? 0 : 1);
    }

    /** Returns the upward normal of a triangle; its length is not 1. */
    private Vec3 upwards(int triangle) {
        int column = (triangle >> 1) % (columns - 1);
        int row = (triangle >> 1) / (columns - 1);
        double least = height(column, row);
        double greatest = height(column + 1, row + 1);
        boolean isGreaterZ = (triangle & 1) == 0;
        double between = isGreaterZ ? height(column, row + 1) : height(column + 1, row);
        return isGreaterZ
                ? new Vec3(between - greatest, cellX, (least - between) * (cellX / cellZ))
                : new Vec3(least - between, cellX, (between - greatest) * (cellX / cellZ));
    }

    /** Returns the unit normal of a triangle's front face. */
    public Vec3 normal(int triangle) {
        Vec3 up = upwards(triangle);
        return Directions.unit(up);
    }

    /** Returns the ray parameter of the hit of a triangle from either side; infinity for a miss. */
    public double intersection(Ray ray, int triangle) {
        double parameter = signedIntersection(ray, triangle);
        return parameter >= 0 && isNear(ray, parameter, triangle, 0) ? parameter : Double.POSITIVE_INFINITY;
    }

    /** Returns the ray parameter at which a descending ray hits a triangle; infinity for a miss. */
    public double entry(Ray ray, int triangle) {
        Vec3 up = upwards(triangle);
        double rate = up.x() * ray.directionX() + up.y() * ray.directionY() + up.z() * ray.directionZ();
        if (!(rate < 0)) {
            return Double.POSITIVE_INFINITY;
        }
        double parameter = signedIntersection(ray, triangle);
        if (parameter >= 0) {
            return isNear(ray, parameter, triangle, 0) ? parameter : Double.POSITIVE_INFINITY;
        }
        boolean startedOnIt =
                parameter * rate <= ON_SURFACE_METRES * up.length() && isNear(ray, 0, triangle, ON_SURFACE_METRES);
        return startedOnIt ? 0 : Double.POSITIVE_INFINITY;
    }

    private double signedIntersection(Ray ray, int triangle) {
        double[] corners = new double[9];
        for (int corner = 0; corner < 3; corner++) {
            int column = sampleColumn(triangle, corner);
            int row = sampleRow(triangle, corner);
            corners[3 * corner] = x(column);
            corners[3 * corner + 1] = y(height(column, row));
            corners[3 * corner + 2] = z(row);
        }
        return RayTriangleIntersection.hitParameter(ray, corners, 0);
    }

    /**
     * Returns true if a point of the ray is within a triangle's grown box. Without this test, rounding would let a ray
     * parallel to the triangle's plane hit it from anywhere.
     */
    private boolean isNear(Ray ray, double parameter, int triangle, double metres) {
        int column = (triangle >> 1) % (columns - 1);
        int row = (triangle >> 1) / (columns - 1);
        double[] box = new double[6];
        writeTriangle(column, row, triangle & 1, metres + rounding(ray), box);
        double x = ray.originX() + parameter * ray.directionX();
        double y = ray.originY() + parameter * ray.directionY();
        double z = ray.originZ() + parameter * ray.directionZ();
        return box[0] <= x && x <= box[3] && box[1] <= y && y <= box[4] && box[2] <= z && z <= box[5];
    }

    /**
     * Returns the distance in metres by which a ray may miss a triangle and still hit it due to rounding. The signed
     * volumes of {@link RayTriangleIntersection} are products of up to three coordinates relative to the ray's origin: for
     * coordinates up to L and edges of at least one cell c, their zero is off by a few ε L² / c, ε = 2⁻⁵³.
     */
    private double rounding(Ray ray) {
        Aabb all = bounds();
        double farthest = farther(ray.originX(), all.minX(), all.maxX())
                + farther(ray.originY(), all.minY(), all.maxY())
                + farther(ray.originZ(), all.minZ(), all.maxZ());
        return RELATIVE_ROUNDING * farthest * (1 + farthest / Math.min(cellX, cellZ));
    }

    private static double farther(double from, double a, double b) {
        return Math.max(Math.abs(a - from), Math.abs(b - from));
    }

    /** Finds the nearest hit by the caller's own test, the triangle of lowest number among equally near ones. */
    public boolean nearest(Ray ray, double limit, ItemRayTest test, RayHit hit) {
        hit.reset(limit);
        if (ray.isCastable()) {
            new HeightFieldRayQuery(this, ray, 2 * (ON_SURFACE_METRES + rounding(ray)), test, hit).walk();
        }
        return hit.item() >= 0;
    }

    /** Reports every triangle with a box that passes; the order does not follow the triangle numbers. */
    public void passing(BoxTest test, IntConsumer found) {
        passing(pyramid.top(), 0, 0, test, found, new double[6]);
    }

    private void passing(int level, int column, int row, BoxTest test, IntConsumer found, double[] box) {
        writeBlock(level, column, row, 0, box);
        if (!test.passes(box, 0)) {
            return;
        }
        if (level == 0) {
            passingCells(column, row, test, found, box);
            return;
        }
        for (int child = 0; child < 4; child++) {
            int x = 2 * column + (child & 1);
            int z = 2 * row + (child >> 1);
            if (pyramid.has(level - 1, x, z)) {
                passing(level - 1, x, z, test, found, box);
            }
        }
    }

    private void passingCells(int blockColumn, int blockRow, BoxTest test, IntConsumer found, double[] box) {
        int endRow = endCell(blockRow, 0, cellRows());
        int endColumn = endCell(blockColumn, 0, cellColumns());
        for (int row = firstCell(blockRow, 0); row < endRow; row++) {
            for (int column = firstCell(blockColumn, 0); column < endColumn; column++) {
                for (int half = 0; half < 2; half++) {
                    writeTriangle(column, row, half, 0, box);
                    if (test.passes(box, 0)) {
                        found.accept(triangle(column, row, half));
                    }
                }
            }
        }
    }

    /**
     * Reports every triangle with a box that {@code box} may touch along {@code motion}, in no particular order.
     */
    public void swept(Aabb box, Vec3 motion, IntConsumer found) {
        passing(SweptAabb.of(box, motion), found);
    }
}
