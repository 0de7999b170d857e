package nephele.engine.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import org.junit.jupiter.api.Test;

class RayTest {
    /** A ray without a direction, or with a value that is not finite, hits nothing, wherever it starts. */
    @Test
    void aRayWithoutADirectionMissesEvenTheBoxAroundIt() {
        Aabb box = new Aabb(-1, -1, -1, 1, 1, 1);
        double inf = Double.POSITIVE_INFINITY;
        for (double[] d : new double[][] {{0, 0, 0}, {-0.0, 0, 0}, {inf, 0, 0}, {Double.NaN, 1, 0}, {1, -inf, 0}}) {
            assertEquals(inf, new Ray(0, 0, 0, d[0], d[1], d[2]).boxEntry(box, inf));
            assertFalse(new Ray(0, 0, 0, d[0], d[1], d[2]).isCastable());
        }
        assertEquals(inf, new Ray(Double.NaN, 0, 0, 1, 0, 0).boxEntry(box, inf));
        assertEquals(0, new Ray(0, 0, 0, Double.MIN_VALUE, 0, 0).boxEntry(box, inf));
        assertEquals(4, new Ray(-5, 1, -1, 1, 0, -0.0).boxEntry(box, inf));
        assertEquals(inf, new Ray(-5, 1, -1, 1, 0, -0.0).boxEntry(box, 3));
    }
}
