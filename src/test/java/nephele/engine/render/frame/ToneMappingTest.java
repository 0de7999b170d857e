package nephele.engine.render.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.level.ToneCurve;
import org.junit.jupiter.api.Test;

/** The dither of the final quantiser keeps means, and no radiance is too great or too small to be shown. */
class ToneMappingTest {
    private static final int BLOCK = 16;

    /** The mean of any 16 × 16 pixels is the value between two codes that they show, within a twentieth of a code. */
    @Test
    void ditheredCodesHaveTheMeanOfTheirValue() {
        int[][] corners = {{0, 0}, {16, 32}, {37, 91}, {1903, 1064}, {3821, 7}};
        for (int[] corner : corners) {
            for (int part = 0; part < 64; part++) {
                double value = 100 + part / 64.0;
                assertEquals(value, meanCode(value, corner[0], corner[1]), 0.05, "from pixel " + corner[0]);
            }
        }
    }

    private static double meanCode(double value, int column, int row) {
        double sum = 0;
        for (int i = 0; i < BLOCK * BLOCK; i++) {
            sum += Math.rint(value + ToneMapping.ditherOffset(column + i % BLOCK, row + i / BLOCK));
        }
        return sum / (BLOCK * BLOCK);
    }

    /** A value that is a code stays that code, so black stays black and white stays white. */
    @Test
    void theOffsetIsLessThanHalfACode() {
        for (int i = 0; i < 1 << 16; i++) {
            double offset = ToneMapping.ditherOffset(i % 251, i / 251);
            assertTrue(Math.abs(offset) < 0.5, i + ": " + offset);
        }
    }

    @Test
    void everyRadianceHasADisplayValue() {
        for (ToneCurve curve : ToneCurve.values()) {
            for (double bright : new double[] {65504, 159_075e9, 1e300, Double.POSITIVE_INFINITY}) {
                assertEquals(1, ToneMapping.displayValue(bright, 1, curve), 1e-9, curve + " of " + bright);
            }
            for (double dark : new double[] {0, -0.0, -1, Double.NEGATIVE_INFINITY}) {
                assertEquals(0, ToneMapping.displayValue(dark, 1, curve), curve + " of " + dark);
            }
        }
    }
}
