package nephele.engine.cloud.cells;

import java.util.stream.IntStream;
import nephele.engine.cloud.light.AxisDepths;
import nephele.engine.cloud.light.CloudLight;
import nephele.engine.math.Vec3;

/** The light at the centres of cells of a cloud, for one direction of the sun. Immutable. */
public final class LightCells {
    /** Sun-ward depth, diffuse mean, diffuse slope, share from above, share from below. */
    static final int VALUES = 5;

    private final CellBox cells;
    private final float[] values;

    private LightCells(CellBox cells, float[] values) {
        this.cells = cells;
        this.values = values;
    }

    /**
     * Computes the light on all processors.
     *
     * @param divisor cells of the density along each edge of one cell of light
     * @param towardsSun unit
     */
    public static LightCells of(
            DensityCells density, int divisor, CloudLight light, Vec3 towardsSun, DepthBeyond beyond) {
        CellBox cells = density.cells().coarser(divisor);
        var depths = new CellDepths(density, cells, beyond);
        float[] values = new float[VALUES * cells.count()];
        IntStream.range(0, cells.nz()).parallel().forEach(k -> {
            var walk = depths.walk();
            for (int j = 0; j < cells.ny(); j++) {
                for (int i = 0; i < cells.nx(); i++) {
                    AxisDepths axes = depths.axes(i, j, k);
                    double sun = walk.from(i, j, k, towardsSun.x(), towardsSun.y(), towardsSun.z());
                    double shade = walk.from(i, j, k, -towardsSun.x(), -towardsSun.y(), -towardsSun.z());
                    put(values, VALUES * cells.index(i, j, k), light.at(axes, sun, shade));
                }
            }
        });
        return new LightCells(cells, values);
    }

    private static void put(float[] values, int at, CloudLight.AtPoint light) {
        values[at] = (float) light.sunDepth();
        values[at + 1] = (float) light.diffuseMean();
        values[at + 2] = (float) light.diffuseSlope();
        values[at + 3] = (float) light.fromAbove();
        values[at + 4] = (float) light.fromBelow();
    }

    public CellBox cells() {
        return cells;
    }

    float[] values() {
        return values;
    }
}
