package nephele.engine.cloud.field;

import nephele.engine.asset.VoxelGrid;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.MajorantWalk;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;

/**
 * A medium with densities at voxel centres, interpolated trilinearly: clamped at the faces of its box and nothing
 * outside of it, or repeated in x and z.
 */
public final class GridField implements ExtinctionField {
    private final VoxelGrid grid;
    private final double extinctionPerMetre;
    private final Aabb bounds;
    private final GridAxis alongX;
    private final GridAxis alongY;
    private final GridAxis alongZ;
    private final VoxelMaxima maxima;
    private final CellLattice lattice;

    private GridField(VoxelGrid grid, Aabb tile, double extinctionPerMetre, GridAxis.Edge sides, double slackMetres) {
        this.grid = grid;
        this.extinctionPerMetre = extinctionPerMetre;
        alongX = new GridAxis(tile.minX(), tile.maxX(), grid.nx(), sides);
        alongY = new GridAxis(tile.minY(), tile.maxY(), grid.ny(), GridAxis.Edge.CLAMPED);
        alongZ = new GridAxis(tile.minZ(), tile.maxZ(), grid.nz(), sides);
        boolean ends = sides == GridAxis.Edge.CLAMPED;
        double infinite = Double.POSITIVE_INFINITY;
        bounds = ends ? tile : new Aabb(-infinite, tile.minY(), -infinite, infinite, tile.maxY(), infinite);
        double slackVoxels = slackMetres * grid.ny() / (tile.maxY() - tile.minY());
        maxima = VoxelMaxima.of(grid, extinctionPerMetre, sides, slackVoxels);
        lattice = maxima.lattice(tile);
    }

    /** Returns the grid stretched to a box. */
    public static GridField inBox(VoxelGrid grid, Aabb box, double extinctionPerMetre) {
        return new GridField(grid, box, extinctionPerMetre, GridAxis.Edge.CLAMPED, 0);
    }

    /** Returns the grid stretched to a box that is repeated without end in x and z. */
    public static GridField repeated(VoxelGrid grid, Aabb tile, double extinctionPerMetre) {
        return repeated(grid, tile, extinctionPerMetre, 0);
    }

    /** @param slackMetres by which points may be lower or higher than the walked ray */
    static GridField repeated(VoxelGrid grid, Aabb tile, double extinctionPerMetre, double slackMetres) {
        return new GridField(grid, tile, extinctionPerMetre, GridAxis.Edge.REPEATED, slackMetres);
    }

    /** Returns the greatest extinction anywhere. */
    public double greatestPerMetre() {
        float greatest = 0;
        for (float density : grid.values()) {
            greatest = Math.max(greatest, density);
        }
        return extinctionPerMetre * greatest;
    }

    @Override
    public double perMetre(double x, double y, double z) {
        return bounds.contains(x, y, z)
                ? extinctionPerMetre * interpolated(alongX.at(x), alongY.at(y), alongZ.at(z))
                : 0;
    }

    private double interpolated(double u, double v, double w) {
        double floorU = Math.floor(u);
        double floorV = Math.floor(v);
        double floorW = Math.floor(w);
        int i = alongX.lower((int) floorU);
        int nextI = alongX.upper((int) floorU);
        int j = alongY.lower((int) floorV);
        int k = alongZ.lower((int) floorW);
        int near = k * grid.ny();
        int far = alongZ.upper((int) floorW) * grid.ny();
        int nextJ = alongY.upper((int) floorV);
        double ofU = u - floorU;
        double lower = mix(row(near + j, i, nextI, ofU), row(near + nextJ, i, nextI, ofU), v - floorV);
        double upper = mix(row(far + j, i, nextI, ofU), row(far + nextJ, i, nextI, ofU), v - floorV);
        return mix(lower, upper, w - floorW);
    }

    private double row(int row, int i, int nextI, double fraction) {
        int at = row * grid.nx();
        float[] values = grid.values();
        return mix(values[at + i], values[at + nextI], fraction);
    }

    private static double mix(double a, double b, double fraction) {
        return a + (b - a) * fraction;
    }

    @Override
    public boolean isEmpty() {
        return bounds.isEmpty() || maxima.areZero();
    }

    @Override
    public Aabb bounds() {
        return bounds;
    }

    @Override
    public MajorantWalk walk(Ray ray, double fromMetres, double toMetres) {
        return new CellWalk(ray, RaySpan.inBox(ray, bounds, fromMetres, toMetres), lattice, maxima);
    }
}
