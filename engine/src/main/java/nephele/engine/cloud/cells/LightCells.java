package nephele.engine.cloud.cells;

import java.nio.FloatBuffer;
import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.cloud.cells.ShadingCloud.Towards;
import nephele.engine.cloud.light.AxisDepths;
import nephele.engine.cloud.light.CloudLight;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.SpatialIndex;

/** The light at the centres of cells of a cloud, for one direction of the sun. Immutable. */
public final class LightCells {
    /** Numbers of a cell, see {@link CloudLight#put}. */
    static final int VALUES = CloudLight.VALUES;

    /** The usual number of cells of density along each edge of a cell of light. */
    public static final int DIVISOR = 2;

    private final CellBox cells;
    private final float[] values;

    private LightCells(CellBox cells, float[] values) {
        this.cells = cells;
        this.values = values;
    }

    /**
     * The light around a cloud.
     *
     * @param towardsSun unit
     * @param others clouds that shade it
     * @param divisor number of cells of density along each edge of a cell in which it is found
     */
    public record Around(Vec3 towardsSun, List<ShadingCloud> others, int divisor) {}

    /**
     * Computes the light in a box of a cloud on all processors.
     *
     * @param density in the box and in all wider ones: of narrower ones its light is independent
     * @param isLayer whether the cells end at no side
     */
    public static LightCells of(List<DensityCells> density, boolean isLayer, CloudLight physics, Around around) {
        DensityCells dense = density.get(0);
        CellBox cells = dense.cells().coarser(around.divisor);
        float[] values = new float[VALUES * cells.count()];
        var sums = new CellDepths(dense, cells);
        float[] shades = isLayer || around.others.isEmpty() ? null : new float[cells.count()];
        var found = new Finding(cells, sums, new StackDepths(density, isLayer), isLayer, around);
        IntStream.range(0, cells.nz()).parallel().forEach(k -> {
            for (int j = 0; j < cells.ny(); j++) {
                for (int i = 0; i < cells.nx(); i++) {
                    if (isNear(dense, cells, around.divisor, i, j, k)) {
                        found.put(i, j, k, physics, values, shades);
                    }
                }
            }
        });
        if (!isLayer) {
            new ThickCloudLight(cells, sums, physics).mixInto(values, shades, around.towardsSun);
        }
        return new LightCells(cells, values);
    }

    /** Returns false for cells so far from all extinction that no lookup of light there meets any. */
    private static boolean isNear(DensityCells density, CellBox cells, int divisor, int i, int j, int k) {
        CellBox dense = density.cells();
        int x = i * dense.nx() / cells.nx();
        int y = j * dense.ny() / cells.ny();
        int z = k * dense.nz() / cells.nz();
        // The farthest cell of light that is mixed in at a cell with some extinction.
        int farthest = 2 * divisor + 1;
        return density.distances()[dense.index(x, y, z)] < farthest;
    }

    /** Finds the light in cells. Immutable. */
    private static final class Finding {
        private final CellBox cells;
        private final CellDepths sums;
        private final StackDepths depths;
        private final boolean isLayer;
        private final Vec3 sun;
        /** {@code null} if no cloud shades it. */
        private final NearShade others;

        private final double axisCosine;

        private Finding(CellBox cells, CellDepths sums, StackDepths depths, boolean isLayer, Around around) {
            this.cells = cells;
            this.sums = sums;
            this.depths = depths;
            this.isLayer = isLayer;
            sun = around.towardsSun();
            others = around.others().isEmpty()
                    ? null
                    : new NearShade(cells, around.others(), sun, cells.sizeX() / around.divisor());
            axisCosine = -CellStack.diffuseAxis(isLayer, cells, sun).dot(sun);
        }

        /** @param shades takes the depth of other clouds towards the sun; {@code null} if that is not wanted */
        private void put(int i, int j, int k, CloudLight physics, float[] values, float[] shades) {
            double x = cells.centreX(i);
            double y = cells.centreY(j);
            double z = cells.centreZ(k);
            AxisDepths axes = axes(i, j, k, x, y, z);
            double sunDepth = depths.from(0, x, y, z, sun.x(), sun.y(), sun.z());
            double shadeDepth = depths.from(0, x, y, z, -sun.x(), -sun.y(), -sun.z());
            if (others != null) {
                axes = axes.with(others.from(Towards.SKY, i, j, k), others.from(Towards.GROUND, i, j, k));
                double shade = others.from(Towards.LIGHT, i, j, k);
                sunDepth += shade;
                shadeDepth += others.from(Towards.SHADE, i, j, k);
                if (shades != null) {
                    shades[cells.index(i, j, k)] = (float) shade;
                }
            }
            physics.put(axes, sunDepth, shadeDepth, axisCosine, values, VALUES * cells.index(i, j, k));
        }

        private AxisDepths axes(int i, int j, int k, double x, double y, double z) {
            AxisDepths inBox = sums.axes(i, j, k);
            return isLayer
                    ? new AxisDepths(
                            depths.nearBy(0, x, y, z, 1, 0, 0),
                            depths.nearBy(0, x, y, z, -1, 0, 0),
                            inBox.y(),
                            inBox.minusY(),
                            depths.nearBy(0, x, y, z, 0, 0, 1),
                            depths.nearBy(0, x, y, z, 0, 0, -1))
                    : inBox;
        }
    }

    public CellBox cells() {
        return cells;
    }

    float[] values() {
        return values;
    }

    /** Puts a slice as texels: the first four numbers of each cell. */
    public void put(int k, FloatBuffer texels) {
        int first = VALUES * cells.index(0, 0, k);
        for (int n = 0; n < cells.nx() * cells.ny(); n++) {
            texels.put(values, first + n * VALUES, 4);
        }
    }

    /**
     * Optical depths of other clouds from the cells of a box. A spatial index tells for blocks of cells which clouds lie in each
     * direction, so that a cell asks only these. Immutable.
     */
    private static final class NearShade {
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
        private NearShade(CellBox cells, List<ShadingCloud> others, Vec3 light, double edgeMetres) {
            this.cells = cells;
            this.edgeMetres = edgeMetres;
            clouds = others.stream().map(cloud -> cloud.depths(light)).toArray(ShadingCloud.Depths[]::new);
            blocksX = blocks(cells.nx());
            blocksY = blocks(cells.ny());
            int count = blocksX * blocksY * blocks(cells.nz());
            near = new int[Towards.values().length][count][];
            var index =
                    SpatialIndex.of(others.stream().map(ShadingCloud::bounds).toList());
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
        private double from(Towards towards, int i, int j, int k) {
            int block = (k / BLOCK * blocksY + j / BLOCK) * blocksX + i / BLOCK;
            double sum = 0;
            for (int cloud : near[towards.ordinal()][block]) {
                sum += clouds[cloud].from(towards, cells.centreX(i), cells.centreY(j), cells.centreZ(k), edgeMetres);
            }
            return sum;
        }
    }
}
