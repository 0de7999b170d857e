package nephele.engine.math.heightfield;

import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/**
 * The surface of a {@link HeightField} as a function of the place: its height, and the smooth normal with which it is
 * shaded. The normal follows from the slope, which is bilinear between the samples' central differences, so it does not
 * depend on the triangles that are drawn.
 */
public final class HeightFieldSurface {
    private HeightFieldSurface() {}

    /** Returns the world y of the triangles at a place; NaN beside the field. */
    public static double y(HeightField field, double x, double z) {
        double across = (x - field.origin().x()) / field.cellX();
        double along = (z - field.origin().z()) / field.cellZ();
        if (!(across >= 0 && along >= 0 && across <= field.cellColumns() && along <= field.cellRows())) {
            return Double.NaN;
        }
        int column = Math.min((int) across, field.cellColumns() - 1);
        int row = Math.min((int) along, field.cellRows() - 1);
        double u = across - column;
        double v = along - row;
        double least = field.height(column, row);
        double greatest = field.height(column + 1, row + 1);
        double height;
        if (v >= u) {
            double between = field.height(column, row + 1);
            height = least + v * (between - least) + u * (greatest - between);
        } else {
            double between = field.height(column + 1, row);
            height = least + u * (between - least) + v * (greatest - between);
        }
        return field.y(height);
    }

    /** Returns the rise along x at a sample: the central difference, at the border the one-sided. */
    public static double riseAlongX(HeightField field, int column, int row) {
        int before = Math.max(column - 1, 0);
        int after = Math.min(column + 1, field.cellColumns());
        return (field.height(after, row) - field.height(before, row)) / ((after - before) * field.cellX());
    }

    /** Returns the rise along z at a sample, as {@link #riseAlongX}. */
    public static double riseAlongZ(HeightField field, int column, int row) {
        int before = Math.max(row - 1, 0);
        int after = Math.min(row + 1, field.cellRows());
        return (field.height(column, after) - field.height(column, before)) / ((after - before) * field.cellZ());
    }

    /** Returns the smooth unit normal at a place; beside the field that of the nearest point of its border. */
    public static Vec3 normal(HeightField field, double x, double z) {
        double across = clamped((x - field.origin().x()) / field.cellX(), field.cellColumns());
        double along = clamped((z - field.origin().z()) / field.cellZ(), field.cellRows());
        int column = Math.min((int) across, field.cellColumns() - 1);
        int row = Math.min((int) along, field.cellRows() - 1);
        double riseX = 0;
        double riseZ = 0;
        for (int corner = 0; corner < 4; corner++) {
            int c = column + (corner & 1);
            int r = row + (corner >> 1);
            double weight = (1 - Math.abs(across - c)) * (1 - Math.abs(along - r));
            riseX += weight * riseAlongX(field, c, r);
            riseZ += weight * riseAlongZ(field, c, r);
        }
        return Directions.unit(new Vec3(-riseX, 1, -riseZ));
    }

    private static double clamped(double cells, int most) {
        return Math.max(0, Math.min(cells, most));
    }
}
