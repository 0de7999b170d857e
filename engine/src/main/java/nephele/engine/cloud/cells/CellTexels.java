package nephele.engine.cloud.cells;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;

/** Writes the cells of a cloud as texels, slice by slice. */
public final class CellTexels {
    private CellTexels() {}

    /**
     * Puts a slice of a box between two times: density at the earlier time, distance divided by {@link
     * DensityCells#FARTHEST}, what absorption leaves, density at the later time.
     */
    public static void putDensity(CellStack from, CellStack to, int box, int k, ByteBuffer texels) {
        DensityCells density = from.density().get(box);
        DensityCells later = to.density().get(box);
        CellBox cells = density.cells();
        LightCells lightOfBox = from.light().get(box);
        boolean absorbs = from.physics().optics().albedo() < 1;
        var lit = new CellPlace(lightOfBox.cells());
        float[] light = lightOfBox.values();
        for (int j = 0; j < cells.ny(); j++) {
            for (int i = 0; i < cells.nx(); i++) {
                int at = cells.index(i, j, k);
                double left = 1;
                if (absorbs) {
                    lit.at(cells.centreX(i), cells.centreY(j), cells.centreZ(k));
                    left = lit.of(light, LightCells.VALUES, 3) + lit.of(light, LightCells.VALUES, 4);
                }
                int distance = Math.min(density.distances()[at], later.distances()[at]);
                texels.put((byte) Math.round(255 * density.densities()[at]))
                        .put((byte) (255 * distance / DensityCells.FARTHEST))
                        .put((byte) Math.round(255 * Math.min(1, left)))
                        .put((byte) Math.round(255 * later.densities()[at]));
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
