package nephele.engine.cloud.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import nephele.engine.asset.VoxelGrid;
import nephele.engine.math.Aabb;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class PlanMapTest {
    private static final int COLUMNS = 37;
    private static final int ROWS = 50;
    private static final Aabb BOX = new Aabb(-10, 0, 5, 64, 1, 105);

    private static PlanMap map(GridAxis.Edge edge, SplittableRandom random) {
        float[] values = new float[COLUMNS * ROWS];
        for (int i = 0; i < values.length; i++) {
            values[i] = (float) Math.pow(random.nextDouble(), 20);
        }
        return new PlanMap(new VoxelGrid(COLUMNS, 1, ROWS, BOX, values), edge);
    }

    @ParameterizedTest
    @EnumSource
    void theBoundOfARectangleOfAnySizeIsNotBelowItsValues(GridAxis.Edge edge) {
        var random = new SplittableRandom(5);
        PlanMap map = map(edge, random);
        for (int i = 0; i < 4000; i++) {
            double x = 400 * random.nextDouble() - 200;
            double z = 400 * random.nextDouble() - 200;
            double width = 90 * Math.pow(random.nextDouble(), 3);
            double depth = 120 * Math.pow(random.nextDouble(), 3);
            double bound = map.greatest(x, z, x + width, z + depth);
            for (int j = 0; j < 30; j++) {
                double value = map.at(x + width * random.nextDouble(), z + depth * random.nextDouble());
                assertTrue(value <= bound, edge + " " + x + " " + z + " " + width + " " + depth);
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    void theBoundOfAllIsTheGreatestValue(GridAxis.Edge edge) {
        PlanMap map = map(edge, new SplittableRandom(5));
        double greatest = 0;
        for (int k = 0; k < ROWS; k++) {
            for (int i = 0; i < COLUMNS; i++) {
                greatest = Math.max(greatest, map.at(-10 + 2 * (i + 0.5), 5 + 2 * (k + 0.5)));
            }
        }
        assertEquals(greatest, map.greatest(-1000, -1000, 1000, 1000), 1e-7);
    }

    @ParameterizedTest
    @EnumSource
    void theBoundOfASmallRectangleIsTight(GridAxis.Edge edge) {
        var random = new SplittableRandom(6);
        PlanMap map = map(edge, random);
        int tight = 0;
        for (int i = 0; i < 1000; i++) {
            double x = 200 * random.nextDouble() - 100;
            double z = 200 * random.nextDouble() - 100;
            tight += map.greatest(x, z, x + 1, z + 1) < 0.5 ? 1 : 0;
        }
        assertTrue(tight > 200, tight + " of 1000 bounds are far below the greatest value");
    }

    /** Between pixels the value is bilinear: that of a picture that rises evenly is exact everywhere. */
    @Test
    void anEvenSlopeIsExactBetweenPixels() {
        float[] values = new float[COLUMNS * ROWS];
        for (int i = 0; i < values.length; i++) {
            values[i] = i % COLUMNS + 100f * (i / COLUMNS);
        }
        PlanMap map = new PlanMap(new VoxelGrid(COLUMNS, 1, ROWS, BOX, values), GridAxis.Edge.CLAMPED);
        assertEquals(10.25 + 100 * 20.75, map.at(-10 + 2 * 10.75, 5 + 2 * 21.25), 1e-3);
    }
}
