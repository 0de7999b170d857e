package nephele.engine.cloud.cells;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import nephele.engine.cloud.DeltaScaling;
import nephele.engine.cloud.TwoStreamSlab;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Diffuse light on cells: closed forms of a slab and a ball, no matter how thin or dense. */
class DiffusionGridTest {
    private static final Vec3 UP = new Vec3(0, 1, 0);

    private static double[] solved(CellBox cells, float[] perMetre, float[] sunDepths, DeltaScaling medium) {
        var guess = new double[cells.count()];
        return new DiffusionGrid(cells, perMetre, sunDepths, 1, medium, UP, guess).solve();
    }

    /** The middle of a wide slab that scatters to all sides, under an upright beam, against Eddington's closed form. */
    @ParameterizedTest
    @CsvSource({"10, 1", "40, 1", "40, 0.98"})
    void aWideSlabHasTheLightOfTheClosedForm(double depth, double albedo) {
        DeltaScaling medium = DeltaScaling.of(albedo, 0, 0);
        var cells = new CellBox(new Aabb(-1000, 0, -1000, 1000, 100, 1000), 40, 40, 40);
        float[] perMetre = new float[cells.count()];
        Arrays.fill(perMetre, (float) (depth / 100));
        float[] sunDepths = new float[cells.count()];
        for (int i = 0; i < sunDepths.length; i++) {
            sunDepths[i] = (float) (depth * (1 - (i / 40 % 40 + 0.5) / 40));
        }
        double[] fluence = solved(cells, perMetre, sunDepths, medium);
        TwoStreamSlab slab = TwoStreamSlab.underBeam(medium, depth, 1);
        for (int row = 1; row < 39; row += 6) {
            int cell = cells.index(20, row, 20);
            double exact = slab.diffuseFluence(sunDepths[cell]);
            assertEquals(exact, fluence[cell], 0.06 * exact + 3e-3, "row " + row);
        }
    }

    /**
     * A ball under the same beam everywhere, with its source q, in clear air that conducts light over l: φ = q ((R² − r²)/(6 D) + 2 R/3
     * / (1 + l/R)).
     */
    @Test
    void aBallInClearAirLosesLightAsAFreeOneDoes() {
        DeltaScaling medium = DeltaScaling.of(1, 0, 0);
        var cells = CellBox.of(Aabb.around(Vec3.ZERO, new Vec3(300, 300, 300)), 60);
        float[] perMetre = new float[cells.count()];
        double radius = 100;
        double extinction = 0.05;
        for (int i = 0; i < perMetre.length; i++) {
            Vec3 centre = new Vec3(cells.centreX(i % 60), cells.centreY(i / 60 % 60), cells.centreZ(i / 3600));
            perMetre[i] = centre.length() < radius ? (float) extinction : 0;
        }
        double[] fluence = solved(cells, perMetre, new float[cells.count()], medium);
        double edge = extinction * cells.sizeY();
        double source = extinction * -Math.expm1(-edge) / edge;
        double middle = source * (radius * radius * 3 * extinction / 6 + 2 * radius / 3 / 1.6);
        assertEquals(middle, fluence[cells.index(30, 30, 30)], 0.1 * middle);
        double outer = source * ((radius * radius - 80 * 80) * 3 * extinction / 6 + 2 * radius / 3 / 1.6);
        assertEquals(outer, fluence[cells.index(46, 30, 30)], 0.1 * outer);
    }

    @ParameterizedTest
    @ValueSource(floats = {0, 1e-12f, 1e-6f, 1, 1e6f, 1e12f})
    void noExtinctionIsTooThinOrTooDense(float extinction) {
        DeltaScaling medium = DeltaScaling.of(1, 0.85, 0.85 * 0.85);
        var cells = CellBox.of(Aabb.around(Vec3.ZERO, new Vec3(300, 300, 300)), 8);
        float[] perMetre = new float[cells.count()];
        perMetre[cells.index(4, 4, 4)] = extinction;
        perMetre[cells.index(4, 3, 4)] = extinction;
        float[] sunDepths = new float[cells.count()];
        sunDepths[cells.index(4, 4, 4)] = 19 * extinction;
        sunDepths[cells.index(4, 3, 4)] = 57 * extinction;
        for (double one : solved(cells, perMetre, sunDepths, medium)) {
            assertTrue(one >= -1e-3 && one < 100, "fluence " + one);
        }
    }
}
