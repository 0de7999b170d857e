package nephele.engine.scene.light;

import java.util.stream.IntStream;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;

/**
 * The sky visibility of a terrain: at points of a grid, the cosine-weighted share of the hemisphere about the smooth
 * normal that the terrain's own heights leave open. In each of {@link #AZIMUTHS} directions it finds the horizon (Max
 * 1988, "Horizon mapping") and integrates the cosine above it in closed form. Other shapes are left out.
 *
 * @param values row by row from the least z, 0 to 255 for 0 to 1
 */
public record TerrainSky(int columns, int rows, byte[] values) {
    /** The most points along a side. */
    private static final int MOST_POINTS = 257;

    private static final int AZIMUTHS = 16;

    /** The factor by which the steps along a direction grow, from the second cell on. */
    private static final double GROWTH = 1.3;

    /** Finds the visibility at the field's samples, or at fewer points of a large one. */
    public static TerrainSky of(HeightField field) {
        int columns = Math.min(field.cellColumns() + 1, MOST_POINTS);
        int rows = Math.min(field.cellRows() + 1, MOST_POINTS);
        byte[] values = new byte[columns * rows];
        IntStream.range(0, rows).parallel().forEach(row -> {
            for (int column = 0; column < columns; column++) {
                double x = field.x(0) + field.cellX() * field.cellColumns() * column / (columns - 1);
                double z = field.z(0) + field.cellZ() * field.cellRows() * row / (rows - 1);
                values[row * columns + column] = (byte) Math.round(255 * share(field, x, z));
            }
        });
        return new TerrainSky(columns, rows, values);
    }

    /** Returns the share at a place of the field. */
    public static double share(HeightField field, double x, double z) {
        double y = HeightFieldSurface.y(field, clamped(x, field, true), clamped(z, field, false));
        Vec3 normal = HeightFieldSurface.normal(field, x, z);
        double sum = 0;
        for (int i = 0; i < AZIMUTHS; i++) {
            double angle = 2 * Math.PI * (i + 0.5) / AZIMUTHS;
            double towardsX = Math.cos(angle);
            double towardsZ = Math.sin(angle);
            double along = normal.x() * towardsX + normal.z() * towardsZ;
            double tangent = Math.max(horizon(field, x, y, z, towardsX, towardsZ), -along / normal.y());
            sum += above(Math.atan(tangent), normal.y(), along);
        }
        return Math.max(0, Math.min(1, 2 * sum / AZIMUTHS));
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
}
