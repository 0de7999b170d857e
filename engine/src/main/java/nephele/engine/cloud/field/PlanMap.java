package nephele.engine.cloud.field;

import nephele.engine.asset.VoxelGrid;
import nephele.engine.math.Aabb;

/**
 * Values on a rectangle as seen from above, interpolated bilinearly between pixel centres; the picture's top is at −z.
 */
final class PlanMap {
    private final VoxelGrid pixels;
    private final GridAxis alongX;
    private final GridAxis alongZ;
    private final GridAxis.Edge edge;
    private final BlockPyramid maxima;
    private final CellLattice blocks;

    /** @param pixels one layer of voxels, which covers the sides of its box */
    PlanMap(VoxelGrid pixels, GridAxis.Edge edge) {
        this.pixels = pixels;
        this.edge = edge;
        Aabb box = pixels.box();
        alongX = new GridAxis(box.minX(), box.maxX(), pixels.nx(), edge);
        alongZ = new GridAxis(box.minZ(), box.maxZ(), pixels.nz(), edge);
        VoxelMaxima greatest = VoxelMaxima.of(pixels, 1, edge);
        maxima = new BlockPyramid(greatest);
        blocks = greatest.lattice(box);
    }

    double at(double x, double z) {
        double u = alongX.at(x);
        double w = alongZ.at(z);
        int floorU = (int) Math.floor(u);
        int floorW = (int) Math.floor(w);
        double near = row(alongZ.lower(floorW), floorU, u - floorU);
        return near + (row(alongZ.upper(floorW), floorU, u - floorU) - near) * (w - floorW);
    }

    private double row(int k, int floorU, double share) {
        double left = pixels.value(alongX.lower(floorU), 0, k);
        return left + (pixels.value(alongX.upper(floorU), 0, k) - left) * share;
    }

    boolean isBlack() {
        return maxima.greatestOfAll() == 0;
    }

    /** Returns an upper bound of the values in a rectangle. */
    double greatest(double fromX, double fromZ, double toX, double toZ) {
        long firstI = block((fromX - blocks.originX()) / blocks.sizeX(), maxima.columns());
        long firstK = block((fromZ - blocks.originZ()) / blocks.sizeZ(), maxima.rows());
        long lastI = block((toX - blocks.originX()) / blocks.sizeX(), maxima.columns());
        long lastK = block((toZ - blocks.originZ()) / blocks.sizeZ(), maxima.rows());
        return maxima.greatest(firstI, firstK, lastI, lastK);
    }

    private long block(double at, int count) {
        long block = (long) Math.floor(at);
        return edge == GridAxis.Edge.REPEATED ? block : Math.max(0, Math.min(block, count - 1));
    }
}
