package nephele.engine.cloud.cells;

import nephele.engine.cloud.DeltaScaling;
import nephele.engine.cloud.light.AxisDepths;
import nephele.engine.cloud.light.CloudLight;
import nephele.engine.math.Vec3;

/**
 * The diffuse light of a thick cloud that is no layer, from a {@link DiffusionGrid}: between many sides the slab that the
 * cloud resembles at a point is too bright in the shade and too dark in the sun. A thin cloud and a flat one keep the slab's light, which
 * is better there; between them is a mixture.
 */
final class ThickCloudLight {
    /** Reduced optical depths, τ (1 − g), up to which clouds are thin and from which on they are thick. */
    private static final double THIN = 1.2;

    private static final double THICK = 3.6;
    /** {@link AxisDepths#flatness()} up to which clouds are round and from which on they are flat. */
    private static final double ROUND = 0.1;

    private static final double FLAT = 0.35;

    private final CellBox cells;
    private final CellDepths depths;
    private final CloudLight physics;

    ThickCloudLight(CellBox cells, CellDepths depths, CloudLight physics) {
        this.cells = cells;
        this.depths = depths;
        this.physics = physics;
    }

    /**
     * Mixes the light of a thick cloud into that of slabs. What lies behind another cloud keeps the slab's light, which the
     * other one is a part of.
     *
     * @param values of {@link LightCells}
     * @param shades optical depths of other clouds from the cells towards the sun; {@code null} for none
     */
    void mixInto(float[] values, float[] shades, Vec3 towardsSun) {
        double fraction = fraction();
        if (fraction == 0) {
            return;
        }
        double[] guess = new double[cells.count()];
        for (int i = 0; i < guess.length; i++) {
            guess[i] = 4 * Math.PI * values[LightCells.VALUES * i + 1];
        }
        DeltaScaling medium = physics.medium();
        var grid = new DiffusionGrid(cells, depths.perMetre(), values, LightCells.VALUES, medium, towardsSun, guess);
        double[] fluence = grid.solve();
        Vec3 axis = CellStack.diffuseAxis(false, cells, towardsSun);
        double reduced = medium.depthFactor() * (1 - medium.albedo() * medium.g());
        for (int i = 0; i < fluence.length; i++) {
            double mean = Math.max(0, fluence[i]) / (4 * Math.PI);
            double slope = grid.fall(i, axis) / (4 * Math.PI * Math.max(1e-9, reduced * depths.perMetre()[i]));
            double own = shades == null ? fraction : fraction * Math.exp(-medium.depthFactor() * shades[i]);
            mix(values, LightCells.VALUES * i + 1, mean, own);
            mix(values, LightCells.VALUES * i + 2, Math.max(-mean, Math.min(mean, slope)), own);
        }
    }

    private static void mix(float[] values, int at, double value, double fraction) {
        values[at] += (float) (fraction * (value - values[at]));
    }

    /** Returns the fraction of the grid's light, from the means over what extinction there is. */
    double fraction() {
        double extinction = 0;
        double thickness = 0;
        double flatness = 0;
        for (int k = 0; k < cells.nz(); k++) {
            for (int j = 0; j < cells.ny(); j++) {
                for (int i = 0; i < cells.nx(); i++) {
                    double perMetre = depths.perMetre()[cells.index(i, j, k)];
                    if (perMetre > 0) {
                        AxisDepths axes = depths.axes(i, j, k);
                        extinction += perMetre;
                        thickness += perMetre * axes.slabThickness();
                        flatness += perMetre * axes.flatness();
                    }
                }
            }
        }
        if (extinction == 0) {
            return 0;
        }
        DeltaScaling medium = physics.medium();
        double reduced = medium.depthFactor() * (1 - medium.g()) * thickness / extinction;
        return clamped((reduced - THIN) / (THICK - THIN)) * clamped((FLAT - flatness / extinction) / (FLAT - ROUND));
    }

    private static double clamped(double fraction) {
        return Math.max(0, Math.min(1, fraction));
    }
}
