package nephele.engine.scene.light;

import java.util.Optional;
import java.util.stream.IntStream;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.math.heightfield.SampleRange;

/**
 * The sky visibility of a terrain: at points of a grid, the cosine-weighted share of the hemisphere about the smooth
 * normal that the terrain's own heights leave open. In each of {@link #AZIMUTHS} directions it finds the horizon (Max
 * 1988, "Horizon mapping") and integrates the cosine above it in closed form. Other shapes are left out.
 */
public final class TerrainSky {
    /** The most points along a side. */
    private static final int MOST_POINTS = 257;

    private static final int AZIMUTHS = 16;
    private static final double[] TOWARDS_X = new double[AZIMUTHS];
    private static final double[] TOWARDS_Z = new double[AZIMUTHS];

    static {
        for (int i = 0; i < AZIMUTHS; i++) {
            double angle = 2 * Math.PI * (i + 0.5) / AZIMUTHS;
            TOWARDS_X[i] = Math.cos(angle);
            TOWARDS_Z[i] = Math.sin(angle);
        }
    }

    /** The factor by which the steps along a direction grow, from the second cell on. */
    private static final double GROWTH = 1.3;

    private final HeightField field;
    private final int columns;
    private final int rows;
    /** The tangents of the elevations of the horizons, {@link #AZIMUTHS} for each point. */
    private final float[] tangents;

    private final byte[] values;

    private TerrainSky(HeightField field, float[] tangents, byte[] values) {
        this.field = field;
        columns = points(field.cellColumns());
        rows = points(field.cellRows());
        this.tangents = tangents;
        this.values = values;
    }

    /** Returns the number of points along a side of so many cells. */
    public static int points(int cells) {
        return Math.min(cells + 1, MOST_POINTS);
    }

    /** Finds the visibility at the field's samples, or at fewer points of a large one. */
    public static TerrainSky of(HeightField field) {
        int points = points(field.cellColumns()) * points(field.cellRows());
        TerrainSky made = new TerrainSky(field, new float[AZIMUTHS * points], new byte[points]);
        made.find(null);
        return made;
    }

    /** Finds the visibility of a field from that of another one: again only where different heights can be seen. */
    public static TerrainSky edited(TerrainSky before, HeightField field) {
        Optional<SampleRange> changed = field.difference(before.field);
        if (changed.isEmpty() || !field.origin().equals(before.field.origin())) {
            return of(field);
        }
        TerrainSky made = new TerrainSky(field, before.tangents.clone(), before.values.clone());
        if (!changed.get().isEmpty()) {
            VisibleChange visible = VisibleChange.of(before.field, field, changed.get());
            made.find(visible);
        }
        return made;
    }

    /** @param changed {@code null} if everything is new */
    private void find(VisibleChange changed) {
        IntStream.range(0, rows).parallel().forEach(row -> {
            for (int column = 0; column < columns; column++) {
                double x = field.x(0) + field.cellX() * field.cellColumns() * column / (columns - 1);
                double z = field.z(0) + field.cellZ() * field.cellRows() * row / (rows - 1);
                find(row * columns + column, x, z, changed);
            }
        });
    }

    private void find(int point, double x, double z, VisibleChange changed) {
        boolean isWholly = changed == null || changed.isAt(x, z);
        boolean isOther = isWholly;
        double y = groundAt(field, x, z);
        for (int i = 0; i < AZIMUTHS; i++) {
            int at = AZIMUTHS * point + i;
            if (isWholly || changed.changesHorizon(x, y, z, TOWARDS_X[i], TOWARDS_Z[i], tangents[at])) {
                tangents[at] = (float) horizon(field, x, y, z, TOWARDS_X[i], TOWARDS_Z[i]);
                isOther = true;
            }
        }
        if (isOther) {
            Vec3 normal = HeightFieldSurface.normal(field, x, z);
            double sum = 0;
            for (int i = 0; i < AZIMUTHS; i++) {
                sum += open(normal, i, tangents[AZIMUTHS * point + i]);
            }
            values[point] = (byte) Math.round(255 * Math.max(0, Math.min(1, 2 * sum / AZIMUTHS)));
        }
    }

    /** Returns the number of points along x. */
    public int columns() {
        return columns;
    }

    /** Returns the number of points along z. */
    public int rows() {
        return rows;
    }

    /** Returns the values row by row from the least z, 0 to 255 for 0 to 1. */
    public byte[] values() {
        return values.clone();
    }

    /** Returns the field. */
    public HeightField field() {
        return field;
    }

    /** Returns the share at a place of the field. */
    public static double share(HeightField field, double x, double z) {
        double y = groundAt(field, x, z);
        Vec3 normal = HeightFieldSurface.normal(field, x, z);
        double sum = 0;
        for (int i = 0; i < AZIMUTHS; i++) {
            sum += open(normal, i, horizon(field, x, y, z, TOWARDS_X[i], TOWARDS_Z[i]));
        }
        return Math.max(0, Math.min(1, 2 * sum / AZIMUTHS));
    }

    private static double groundAt(HeightField field, double x, double z) {
        return HeightFieldSurface.y(field, clamped(x, field, true), clamped(z, field, false));
    }

    /** Returns what the horizon in a direction leaves open. */
    private static double open(Vec3 normal, int azimuth, double horizonTangent) {
        double along = normal.x() * TOWARDS_X[azimuth] + normal.z() * TOWARDS_Z[azimuth];
        double tangent = Math.max(horizonTangent, -along / normal.y());
        return above(Math.atan(tangent), normal.y(), along);
    }

    private static double clamped(double place, HeightField field, boolean isX) {
        double least = isX ? field.x(0) : field.z(0);
        double most = isX ? field.x(field.cellColumns()) : field.z(field.cellRows());
        return Math.max(least, Math.min(most, place));
    }

    /** Returns ∫ (up sin θ + along cos θ) cos θ dθ from an elevation to the zenith. */
    private static double above(double elevation, double up, double along) {
        double sine = Math.sin(elevation);
        double cosine = Math.cos(elevation);
        return (up * cosine * cosine + along * (Math.PI / 2 - elevation - sine * cosine)) / 2;
    }

    /** Returns the tangent of the horizon's elevation in a direction. */
    private static double horizon(HeightField field, double x, double y, double z, double towardsX, double towardsZ) {
        double step = Math.min(field.cellX(), field.cellZ());
        double distance = step;
        double steepest = Double.NEGATIVE_INFINITY;
        while (true) {
            double there = HeightFieldSurface.y(field, x + distance * towardsX, z + distance * towardsZ);
            if (Double.isNaN(there)) {
                return steepest;
            }
            steepest = Math.max(steepest, (there - y) / distance);
            distance = Math.max(distance + step, distance * GROWTH);
        }
    }

    /**
     * A rectangle of changed heights as it is visible from places of the ground.
     *
     * @param top the greatest world y in it, before and after
     */
    private record VisibleChange(double minX, double minZ, double maxX, double maxZ, double top) {
        /** The smooth normal of a place depends on samples of so many cells around it. */
        private static final int NORMAL_CELLS = 2;

        /** Horizons are floats. */
        private static final double ROUNDING = 1e-6;

        /** @param before has other heights in the range */
        static VisibleChange of(HeightField before, HeightField field, SampleRange changed) {
            SampleRange reach = changed.grown(NORMAL_CELLS);
            return new VisibleChange(
                    field.x(reach.firstColumn()),
                    field.z(reach.firstRow()),
                    field.x(reach.lastColumn()),
                    field.z(reach.lastRow()),
                    Math.max(top(before, reach), top(field, reach)));
        }

        private static double top(HeightField field, SampleRange range) {
            float top = Float.NEGATIVE_INFINITY;
            for (int row = Math.max(0, range.firstRow()); row <= Math.min(range.lastRow(), field.cellRows()); row++) {
                int last = Math.min(range.lastColumn(), field.cellColumns());
                for (int column = Math.max(0, range.firstColumn()); column <= last; column++) {
                    top = Math.max(top, field.height(column, row));
                }
            }
            return field.y(top);
        }

        boolean isAt(double x, double z) {
            return x >= minX && x <= maxX && z >= minZ && z <= maxZ;
        }

        /**
         * Returns true if the horizon of a place may be another one: not where the rectangle is not met, nor where all of it,
         * before and after, is below the horizon that was found.
         *
         * @param y of the ground there
         * @param horizon the tangent of its elevation before
         */
        boolean changesHorizon(double x, double y, double z, double towardsX, double towardsZ, double horizon) {
            double toMinX = (minX - x) / towardsX;
            double toMaxX = (maxX - x) / towardsX;
            double toMinZ = (minZ - z) / towardsZ;
            double toMaxZ = (maxZ - z) / towardsZ;
            double enter = Math.max(Math.min(toMinX, toMaxX), Math.min(toMinZ, toMaxZ));
            double leave = Math.min(Math.max(toMinX, toMaxX), Math.max(toMinZ, toMaxZ));
            if (leave < Math.max(enter, 0)) {
                return false;
            }
            double highest = (top - y) / (top > y ? enter : leave);
            return enter <= 0 || !(highest < horizon - ROUNDING * (1 + Math.abs(horizon)));
        }
    }
}
