package nephele.engine.cloud.field;

import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.MajorantWalk;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/** A medium of noise, bounded in cells of a quarter of a feature. */
public final class NoiseField implements ExtinctionField {
    /** Cells of a walk in a feature: as many as there are blocks of the shape table's maxima. */
    private static final double CELLS_PER_FEATURE = 4;

    /** Least and greatest number of cells across the shortest edge; finer noise has one bound for all. */
    private static final double FEWEST_CELLS = 8;

    private static final double MOST_CELLS = 64;

    /** Greatest number of cells across the longest edge: a column of 100 m by 10 000 km has no million of them. */
    private static final double MOST_CELLS_ALONG = 4096;

    /** Shortest cell of a layer, whose rays may be as long as the world. */
    private static final double LAYER_CELL_METRES = 25;

    private final Aabb bounds;
    private final Vec3 origin;
    private final NoiseDensity density;
    private final double extinctionPerMetre;
    private final double slackMetres;
    private final CellLattice lattice;

    /**
     * @param bounds may be infinite in x and z
     * @param origin of the noise's pattern
     * @param slackMetres by which points may be lower or higher than the walked ray
     */
    NoiseField(
            Aabb bounds,
            Vec3 origin,
            NoiseDensity density,
            double featureMetres,
            double extinctionPerMetre,
            double slackMetres) {
        this.bounds = bounds;
        this.origin = origin;
        this.density = density;
        this.extinctionPerMetre = extinctionPerMetre;
        this.slackMetres = slackMetres;
        double height = bounds.maxY() - bounds.minY();
        double width = Math.min(bounds.maxX() - bounds.minX(), bounds.maxZ() - bounds.minZ());
        double shortest = Math.min(height, width);
        double cell = Math.max(featureMetres / CELLS_PER_FEATURE, shortest / MOST_CELLS);
        double length = Math.max(bounds.maxX() - bounds.minX(), bounds.maxZ() - bounds.minZ());
        double across = width < Double.POSITIVE_INFINITY
                ? Math.max(Math.min(cell, width / FEWEST_CELLS), length / MOST_CELLS_ALONG)
                : Math.max(cell, LAYER_CELL_METRES);
        double up = Math.max(Math.min(cell, height / FEWEST_CELLS), height / MOST_CELLS_ALONG);
        lattice = new CellLattice(origin.x(), origin.y(), origin.z(), across, up, across);
    }

    public NoiseDensity density() {
        return density;
    }

    /** Returns the origin of the noise's pattern, in world metres. */
    public Vec3 origin() {
        return origin;
    }

    public double extinctionPerMetre() {
        return extinctionPerMetre;
    }

    @Override
    public double perMetre(double x, double y, double z) {
        return bounds.contains(x, y, z)
                ? extinctionPerMetre * density.at(x - origin.x(), y - origin.y(), z - origin.z())
                : 0;
    }

    private double bound(long i, long j, long k) {
        double halfX = lattice.sizeX() / 2;
        double halfY = lattice.sizeY() / 2;
        double halfZ = lattice.sizeZ() / 2;
        return extinctionPerMetre
                * density.greatest(
                        (2 * i + 1) * halfX,
                        (2 * j + 1) * halfY,
                        (2 * k + 1) * halfZ,
                        halfX,
                        halfY + slackMetres,
                        halfZ);
    }

    @Override
    public boolean isEmpty() {
        return extinctionPerMetre == 0 || bounds.isEmpty() || density.isEmpty();
    }

    @Override
    public Aabb bounds() {
        return bounds;
    }

    @Override
    public MajorantWalk walk(Ray ray, double fromMetres, double toMetres) {
        return new CellWalk(ray, RaySpan.inBox(ray, bounds, fromMetres, toMetres), lattice, this::bound);
    }
}
