package nephele.engine.cloud.cells;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;

/** Writes the cells of a cloud as texels, slice by slice. */
public final class CellTexels {
    private CellTexels() {}

    /** Puts a slice: density, distance divided by {@link DensityCells#FARTHEST}, what absorption leaves, 255. */
    public static void putDensity(DensityCells density, LightCells lightOfBox, int k, ByteBuffer texels) {
        CellBox cells = density.cells();
        var lit = new CellPlace(lightOfBox.cells());
        float[] light = lightOfBox.values();
        for (int j = 0; j < cells.ny(); j++) {
            for (int i = 0; i < cells.nx(); i++) {
                int at = cells.index(i, j, k);
                lit.at(cells.centreX(i), cells.centreY(j), cells.centreZ(k));
                double left = lit.of(light, LightCells.VALUES, 3) + lit.of(light, LightCells.VALUES, 4);
                texels.put((byte) Math.round(255 * density.densities()[at]))
                        .put((byte) (255 * density.distances()[at] / DensityCells.FARTHEST))
                        .put((byte) Math.round(255 * Math.min(1, left)))
                        .put((byte) 255);
            }
        }
    }

    /** Puts a slice: sun-ward depth, diffuse mean, diffuse slope, share from above. */
    public static void putLight(LightCells light, int k, FloatBuffer texels) {
        CellBox cells = light.cells();
        float[] values = light.values();
        int first = LightCells.VALUES * cells.index(0, 0, k);
        for (int n = 0; n < cells.nx() * cells.ny(); n++) {
            texels.put(values, first + n * LightCells.VALUES, 4);
        }
    }
}
