package nephele.engine.cloud.cells;

import java.util.List;
import nephele.engine.cloud.cells.ShadingCloud.Towards;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.SpatialIndex;

/**
 * Optical depths of other clouds from the cells of a box. A spatial index tells for blocks of cells which clouds lie in each
 * direction, so that a cell asks only these. Immutable.
 */
final class NearShade {
    /** Cells along each edge of a block. */
    private static final int BLOCK = 8;

    private final CellBox cells;
    private final double edgeMetres;
    private final ShadingCloud.Depths[] clouds;
    private final int blocksX;
    private final int blocksY;
    /** Indices of clouds by direction, then by block. */
    private final int[][][] near;

    /** @param edgeMetres width of cells of density that are fine enough */
    NearShade(CellBox cells, List<ShadingCloud> others, Vec3 light, double edgeMetres) {
        this.cells = cells;
        this.edgeMetres = edgeMetres;
        clouds = others.stream().map(cloud -> cloud.depths(light)).toArray(ShadingCloud.Depths[]::new);
        blocksX = blocks(cells.nx());
        blocksY = blocks(cells.ny());
        int count = blocksX * blocksY * blocks(cells.nz());
        near = new int[Towards.values().length][count][];
        var index = SpatialIndex.of(others.stream().map(ShadingCloud::bounds).toList());
        for (Towards towards : Towards.values()) {
            Vec3 direction = towards.direction(light);
            for (int block = 0; block < count; block++) {
                near[towards.ordinal()][block] = ShadingCloud.ahead(index, block(block), direction);
            }
        }
    }

    private static int blocks(int cells) {
        return (cells + BLOCK - 1) / BLOCK;
    }

    /** Returns the box around the centres of a block's cells. */
    private Aabb block(int block) {
        int i = block % blocksX * BLOCK;
        int j = block / blocksX % blocksY * BLOCK;
        int k = block / blocksX / blocksY * BLOCK;
        return new Aabb(
                cells.centreX(i),
                cells.centreY(j),
                cells.centreZ(k),
                cells.centreX(Math.min(i + BLOCK, cells.nx()) - 1),
                cells.centreY(Math.min(j + BLOCK, cells.ny()) - 1),
                cells.centreZ(Math.min(k + BLOCK, cells.nz()) - 1));
    }

    /** Returns the weighted depth of the other clouds from the centre of a cell. */
    double from(Towards towards, int i, int j, int k) {
        int block = (k / BLOCK * blocksY + j / BLOCK) * blocksX + i / BLOCK;
        double sum = 0;
        for (int cloud : near[towards.ordinal()][block]) {
            sum += clouds[cloud].from(towards, cells.centreX(i), cells.centreY(j), cells.centreZ(k), edgeMetres);
        }
        return sum;
    }
}
