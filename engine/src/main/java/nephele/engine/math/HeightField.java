package nephele.engine.math;

/**
 * A surface over a grid of heights: each cell is cut into two triangles along the diagonal from its corner of least x and z
 * to that of greatest x and z. Nothing is made for a cell or a triangle; both are found by arithmetic and through the least
 * and greatest heights of blocks. Triangle 2 (row · cells of a row + column) of a cell is the one with its greater z, the
 * next one that with its greater x; their fronts look up. Immutable and safe to share between threads.
 */
public final class HeightField {
    /** Samples along a side, at most. */
    public static final int MOST_SAMPLES = 8193;

    /** A ray that starts this far below a triangle, and goes down, started on it. */
    private static final double ON_SURFACE_METRES = 1e-9;

    /** Some ninety ε. */
    private static final double ROUNDING = 1e-14;

    private static final double LEAST_CELL_METRES = 1e-3;

    private static final double FARTHEST_METRES = 1e7;

    private final Vec3 origin;
    private final double cellMetres;
    private final int columns;
    private final int rows;
    private final double[] heights;
    private final HeightPyramid pyramid;

    /** Tells the height of each sample. */
    @FunctionalInterface
    public interface Heights {
        double metres(int column, int row);
    }

    private HeightField(Vec3 origin, double cellMetres, int columns, int rows, Heights source) {
        this.origin = origin;
        this.cellMetres = cellMetres;
        this.columns = columns;
        this.rows = rows;
        heights = new double[columns * rows];
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                heights[row * columns + column] = checked(source.metres(column, row), column, row);
            }
        }
        pyramid = new HeightPyramid(heights, columns, rows);
    }

    /**
     * @param origin of the sample at column 0 and row 0, if its height is 0; columns lead along x, rows along z
     * @param source asked once for each sample: metres above the origin
     * @throws IllegalArgumentException with the reason when the grid is too small or too large, or a height is no number
     */
    public static HeightField of(Vec3 origin, double cellMetres, int columns, int rows, Heights source) {
        if (Math.min(columns, rows) < 2 || Math.max(columns, rows) > MOST_SAMPLES) {
            throw new IllegalArgumentException("a height field has 2 to " + MOST_SAMPLES
                    + " samples along each side, not " + columns + " × " + rows);
        }
        if (!(cellMetres >= LEAST_CELL_METRES && cellMetres <= FARTHEST_METRES)) {
            throw new IllegalArgumentException("a height field's cells are " + LEAST_CELL_METRES + " m to "
                    + FARTHEST_METRES + " m wide, not " + cellMetres + " m");
        }
        double farthest = Math.max(
                Math.max(Math.abs(origin.x()), Math.abs(origin.x() + (columns - 1) * cellMetres)),
                Math.max(Math.abs(origin.z()), Math.abs(origin.z() + (rows - 1) * cellMetres)));
        if (!(Math.max(farthest, Math.abs(origin.y())) <= FARTHEST_METRES)) {
            throw new IllegalArgumentException("a height field reaches no farther than " + FARTHEST_METRES
                    + " m from the world's origin; this one begins at " + origin);
        }
        return new HeightField(origin, cellMetres, columns, rows, source);
    }

    private static double checked(double height, int column, int row) {
        if (!(Math.abs(height) <= FARTHEST_METRES)) {
            throw new IllegalArgumentException("the height at column " + column + ", row " + row + " is " + height
                    + ": heights are numbers of metres, at most " + FARTHEST_METRES + " above or below the origin");
        }
        return height;
    }

    public int triangles() {
        return 2 * (columns - 1) * (rows - 1);
    }

    public double cellMetres() {
        return cellMetres;
    }

    int cellColumns() {
        return columns - 1;
    }

    int cellRows() {
        return rows - 1;
    }

    HeightPyramid pyramid() {
        return pyramid;
    }

    double x(int column) {
        return origin.x() + column * cellMetres;
    }

    double z(int row) {
        return origin.z() + row * cellMetres;
    }

    /** The y of a height. */
    double y(double height) {
        return origin.y() + height;
    }

    double height(int column, int row) {
        return heights[row * columns + column];
    }

    /** Around everything. */
    public Aabb bounds() {
        return new Aabb(
                x(0),
                y(pyramid.least(pyramid.top(), 0, 0)),
                z(0),
                x(columns - 1),
                y(pyramid.greatest(pyramid.top(), 0, 0)),
                z(rows - 1));
    }

    /** A corner, 0 to 2, counter-clockwise seen from above; neighbours share the bits of their corners. */
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

    /** Points up out of the triangle's front; its length is not 1. */
    private Vec3 upwards(int triangle) {
        int column = (triangle >> 1) % (columns - 1);
        int row = (triangle >> 1) / (columns - 1);
        double least = height(column, row);
        double greatest = height(column + 1, row + 1);
        boolean isGreaterZ = (triangle & 1) == 0;
        double between = isGreaterZ ? height(column, row + 1) : height(column + 1, row);
        return isGreaterZ
                ? new Vec3(between - greatest, cellMetres, least - between)
                : new Vec3(least - between, cellMetres, between - greatest);
    }

    /** The unit normal of a triangle's front. */
    public Vec3 normal(int triangle) {
        Vec3 up = upwards(triangle);
        return Directions.unit(up);
    }

    /** The ray parameter at which a ray meets a triangle from either side; infinity for a miss. */
    public double meeting(Ray ray, int triangle) {
        double parameter = signedMeeting(ray, triangle);
        return parameter >= 0 && isNear(ray, parameter, triangle, 0) ? parameter : Double.POSITIVE_INFINITY;
    }

    /** The ray parameter at which a ray goes down through a triangle; infinity for a miss. */
    public double entry(Ray ray, int triangle) {
        Vec3 up = upwards(triangle);
        double rate = up.x() * ray.directionX() + up.y() * ray.directionY() + up.z() * ray.directionZ();
        if (!(rate < 0)) {
            return Double.POSITIVE_INFINITY;
        }
        double parameter = signedMeeting(ray, triangle);
        if (parameter >= 0) {
            return isNear(ray, parameter, triangle, 0) ? parameter : Double.POSITIVE_INFINITY;
        }
        boolean startedOnIt =
                parameter * rate <= ON_SURFACE_METRES * up.length() && isNear(ray, 0, triangle, ON_SURFACE_METRES);
        return startedOnIt ? 0 : Double.POSITIVE_INFINITY;
    }

    private double signedMeeting(Ray ray, int triangle) {
        double[] corners = new double[9];
        for (int corner = 0; corner < 3; corner++) {
            int column = sampleColumn(triangle, corner);
            int row = sampleRow(triangle, corner);
            corners[3 * corner] = x(column);
            corners[3 * corner + 1] = y(height(column, row));
            corners[3 * corner + 2] = z(row);
        }
        return TriangleMeeting.parameter(ray, corners, 0);
    }

    /** Whether a ray is at a triangle's box: along its plane, rounding would have a ray meet it from anywhere. */
    private boolean isNear(Ray ray, double parameter, int triangle, double metres) {
        int column = (triangle >> 1) % (columns - 1);
        int row = (triangle >> 1) / (columns - 1);
        double[] box = new double[6];
        HeightFieldBoxes.writeTriangle(this, column, row, triangle & 1, metres + rounding(ray), box);
        double x = ray.originX() + parameter * ray.directionX();
        double y = ray.originY() + parameter * ray.directionY();
        double z = ray.originZ() + parameter * ray.directionZ();
        return box[0] <= x && x <= box[3] && box[1] <= y && y <= box[4] && box[2] <= z && z <= box[5];
    }

    /**
     * How far from a triangle a ray may pass, in metres, that rounding has meet it. The signed volumes of
     * {@link TriangleMeeting} are products of up to three coordinates relative to the ray's origin: with coordinates up to L
     * and edges of at least a cell c their zero is off by a few ε L² / c, ε = 2⁻⁵³.
     */
    private double rounding(Ray ray) {
        Aabb all = bounds();
        double farthest = farther(ray.originX(), all.minX(), all.maxX())
                + farther(ray.originY(), all.minY(), all.maxY())
                + farther(ray.originZ(), all.minZ(), all.maxZ());
        return ROUNDING * farthest * (1 + farthest / cellMetres);
    }

    private static double farther(double from, double a, double b) {
        return Math.max(Math.abs(a - from), Math.abs(b - from));
    }

    /**
     * The nearest hit by the caller's own test of a triangle, the lowest triangle among equally near ones: just as if every
     * triangle were tested.
     *
     * @param limit greatest ray parameter that counts
     * @param test {@link #entry}, {@link #meeting}, or these for some triangles only
     * @return whether there is one; then {@code hit} holds it
     */
    public boolean nearest(Ray ray, double limit, ItemRayTest test, RayHit hit) {
        hit.reset(limit);
        if (ray.isCastable()) {
            new HeightFieldRay(this, ray, 2 * (ON_SURFACE_METRES + rounding(ray)), test, hit).walk();
        }
        return hit.item() >= 0;
    }

    /** Every triangle whose box passes, in no order that follows from their numbers. */
    public void passing(BoxTest test, ItemVisitor found) {
        new HeightFieldBoxes(this, test, found).walk();
    }

    /** Every triangle whose box {@code box} may touch on its way along {@code motion}, as by {@link #passing}. */
    public void swept(Aabb box, Vec3 motion, ItemVisitor found) {
        passing(Sweep.of(box, motion)::touches, found);
    }
}
