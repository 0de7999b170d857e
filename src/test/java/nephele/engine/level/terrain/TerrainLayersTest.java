package nephele.engine.level.terrain;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import nephele.engine.level.Terrain.Layer;
import nephele.engine.level.TestTerrain;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TerrainLayersTest {
    private static double[] weights(double height, double slopeDegrees, Layer... layers) {
        double[] weights = new double[layers.length];
        TerrainLayers.of(TestTerrain.said("t", "none", layers))
                .weights(height, Math.cos(Math.toRadians(slopeDegrees)), weights);
        return weights;
    }

    private static final Layer LOW = new Layer("low", -1e7, 10, 4, 0, 90);
    private static final Layer HIGH = new Layer("high", 10, 1e7, 4, 0, 90);

    @ParameterizedTest
    @CsvSource({"-50, 1", "8, 1", "9, 0.84375", "10, 0.5", "11, 0.15625", "12, 0", "500, 0"})
    void layersThatMeetFadeIntoEachOther(double height, double low) {
        assertArrayEquals(new double[] {low, 1 - low}, weights(height, 20, LOW, HIGH), 1e-12);
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "30, 1", "33, 0.5", "36.1, 0", "90, 0"})
    void aLimitOfSlopeIsSoftInTheCosine(double slope, double gentle) {
        double[] weights = weights(0, slope, new Layer("g", -1e7, 1e7, 0, 0, 33), new Layer("s", -1e7, 1e7, 0, 33, 90));
        assertEquals(gentle, weights[0], 0.04);
        assertEquals(1, weights[0] + weights[1], 1e-12);
    }

    @Test
    void aSharpLimitCountsForBothLayersAtItsVeryHeight() {
        Layer low = new Layer("low", -1e7, 10, 0, 0, 90);
        Layer high = new Layer("high", 10, 1e7, 0, 0, 90);
        assertArrayEquals(new double[] {1, 0}, weights(Math.nextDown(10), 0, low, high));
        assertArrayEquals(new double[] {0.5, 0.5}, weights(10, 0, low, high));
        assertArrayEquals(new double[] {0, 1}, weights(Math.nextUp(10), 0, low, high));
    }

    @Test
    void bareGroundHasTheFirstLayer() {
        Layer above = new Layer("above", 5, 10, 0, 0, 90);
        assertArrayEquals(new double[] {1, 0}, weights(0, 0, above, above));
        assertArrayEquals(new double[] {0.5, 0.5}, weights(7, 0, above, above));
    }
}
