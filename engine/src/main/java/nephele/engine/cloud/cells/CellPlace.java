package nephele.engine.cloud.cells;

/** The eight cells around a point and their weights, as linear filtering with clamped edges has them. Reusable. */
final class CellPlace {
    private final CellBox cells;
    private int first;
    private int stepX;
    private int stepY;
    private int stepZ;
    private double u;
    private double v;
    private double w;

    CellPlace(CellBox cells) {
        this.cells = cells;
    }

    /** Moves to a point in world metres; outside the box to the nearest point of it. */
    void at(double x, double y, double z) {
        double cx = clamped((x - cells.box().minX()) / cells.sizeX() - 0.5, cells.nx());
        double cy = clamped((y - cells.box().minY()) / cells.sizeY() - 0.5, cells.ny());
        double cz = clamped((z - cells.box().minZ()) / cells.sizeZ() - 0.5, cells.nz());
        int i = (int) cx;
        int j = (int) cy;
        int k = (int) cz;
        u = cx - i;
        v = cy - j;
        w = cz - k;
        first = cells.index(i, j, k);
        stepX = i + 1 < cells.nx() ? 1 : 0;
        stepY = j + 1 < cells.ny() ? cells.nx() : 0;
        stepZ = k + 1 < cells.nz() ? cells.nx() * cells.ny() : 0;
    }

    private static double clamped(double x, int cells) {
        return Math.max(0, Math.min(cells - 1, x));
    }

    /** Returns the interpolated value of an array with several values a cell. */
    double of(float[] values, int valuesPerCell, int value) {
        int at = first * valuesPerCell + value;
        int x = stepX * valuesPerCell;
        int y = stepY * valuesPerCell;
        int z = stepZ * valuesPerCell;
        double near = plane(values, at, x, y);
        return near + w * (plane(values, at + z, x, y) - near);
    }

    private double plane(float[] values, int at, int x, int y) {
        double low = values[at] + u * (values[at + x] - values[at]);
        double high = values[at + y] + u * (values[at + y + x] - values[at + y]);
        return low + v * (high - low);
    }
}
