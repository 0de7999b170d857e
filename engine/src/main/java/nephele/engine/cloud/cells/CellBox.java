package nephele.engine.cloud.cells;

import nephele.engine.math.Aabb;

/**
 * A finite box that is divided into cells.
 *
 * @param nx cells along x, at least 1; {@code ny} and {@code nz} likewise
 */
public record CellBox(Aabb box, int nx, int ny, int nz) {
    /** Returns the box divided into nearly cubic cells. @param longest cells along the longest edge */
    public static CellBox of(Aabb box, int longest) {
        double x = box.maxX() - box.minX();
        double y = box.maxY() - box.minY();
        double z = box.maxZ() - box.minZ();
        double cell = Math.max(x, Math.max(y, z)) / longest;
        return new CellBox(box, cells(x, cell), cells(y, cell), cells(z, cell));
    }

    private static int cells(double metres, double cell) {
        return Math.max(1, (int) Math.round(metres / cell));
    }

    /** Returns the box with a fraction of the cells along each edge, at least 2. */
    public CellBox coarser(int divisor) {
        return new CellBox(box, fewer(nx, divisor), fewer(ny, divisor), fewer(nz, divisor));
    }

    private static int fewer(int cells, int divisor) {
        return Math.max(Math.min(cells, 2), cells / divisor);
    }

    /** Returns the box with one more cell on each side. */
    public CellBox padded() {
        var wider = new Aabb(
                box.minX() - sizeX(),
                box.minY() - sizeY(),
                box.minZ() - sizeZ(),
                box.maxX() + sizeX(),
                box.maxY() + sizeY(),
                box.maxZ() + sizeZ());
        return new CellBox(wider, nx + 2, ny + 2, nz + 2);
    }

    public int count() {
        return nx * ny * nz;
    }

    public int index(int i, int j, int k) {
        return (k * ny + j) * nx + i;
    }

    public double sizeX() {
        return (box.maxX() - box.minX()) / nx;
    }

    public double sizeY() {
        return (box.maxY() - box.minY()) / ny;
    }

    public double sizeZ() {
        return (box.maxZ() - box.minZ()) / nz;
    }

    /** Returns the shortest edge of a cell, metres. */
    public double shortest() {
        return Math.min(sizeX(), Math.min(sizeY(), sizeZ()));
    }

    /** Returns the box of a cell. */
    public Aabb cell(int i, int j, int k) {
        double x = box.minX() + i * sizeX();
        double y = box.minY() + j * sizeY();
        double z = box.minZ() + k * sizeZ();
        return new Aabb(x, y, z, x + sizeX(), y + sizeY(), z + sizeZ());
    }

    public double centreX(int i) {
        return box.minX() + (i + 0.5) * sizeX();
    }

    public double centreY(int j) {
        return box.minY() + (j + 0.5) * sizeY();
    }

    public double centreZ(int k) {
        return box.minZ() + (k + 0.5) * sizeZ();
    }
}
