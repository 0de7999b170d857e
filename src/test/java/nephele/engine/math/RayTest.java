package nephele.engine.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class RayTest {
    private static final double[] COMPONENTS = {
        0, -0.0, 1, -1, 0.5, -2, Double.MIN_VALUE, -Double.MIN_VALUE, 1e-310, 1e300, -1e300, 1e-30
    };
    private static final BigDecimal LARGEST = new BigDecimal(Double.MAX_VALUE);
    private static final double[] PLACES = {0, -0.0, 1, -1, 2, -2, 0.5, 3};

    /** C.2 row 17, at a reduced count: slabs agree with exact arithmetic, but for a border as wide as rounding. */
    @Test
    void slabsAgreeWithExactArithmetic() {
        var random = new SplittableRandom(17);
        int hits = 0;
        for (int i = 0; i < 10_000; i++) {
            double[] o = {pick(random, PLACES), pick(random, PLACES), pick(random, PLACES)};
            double[] d = {pick(random, COMPONENTS), pick(random, COMPONENTS), pick(random, COMPONENTS)};
            Aabb box = new Aabb(-1, -1, -1, 1, random.nextInt(3) - 1, 1);
            Ray ray = new Ray(o[0], o[1], o[2], d[0], d[1], d[2]);
            boolean met = ray.boxEntry(box, Double.POSITIVE_INFINITY) < Double.POSITIVE_INFINITY;
            boolean exact = exactlyMeets(o, d, box);
            assertTrue(met || !exact, () -> "missed by " + java.util.Arrays.toString(o) + java.util.Arrays.toString(d));
            boolean nearly = exact || exactlyMeets(o, d, box.grown(1e-12));
            assertTrue(nearly || !met, () -> "hit by " + java.util.Arrays.toString(o) + java.util.Arrays.toString(d));
            hits += met ? 1 : 0;
        }
        assertTrue(hits > 1000 && hits < 9000, hits + " hits");
    }

    private static double pick(SplittableRandom random, double[] values) {
        return values[random.nextInt(values.length)];
    }

    /** Intersects the three intervals of the ray parameter; a zero direction meets nothing, nor does a parameter beyond double. */
    private static boolean exactlyMeets(double[] o, double[] d, Aabb box) {
        double[] low = {box.minX(), box.minY(), box.minZ()};
        double[] high = {box.maxX(), box.maxY(), box.maxZ()};
        BigDecimal enter = BigDecimal.ZERO;
        BigDecimal leave = null;
        boolean moves = false;
        for (int axis = 0; axis < 3; axis++) {
            if (d[axis] == 0) {
                if (o[axis] < low[axis] || o[axis] > high[axis]) {
                    return false;
                }
                continue;
            }
            moves = true;
            BigDecimal first = parameter(d[axis] > 0 ? low[axis] : high[axis], o[axis], d[axis]);
            BigDecimal last = parameter(d[axis] > 0 ? high[axis] : low[axis], o[axis], d[axis]);
            enter = enter.max(first);
            leave = leave == null ? last : leave.min(last);
        }
        return moves && enter.compareTo(leave) <= 0 && enter.compareTo(LARGEST) <= 0;
    }

    private static BigDecimal parameter(double bound, double origin, double direction) {
        return new BigDecimal(bound)
                .subtract(new BigDecimal(origin))
                .divide(new BigDecimal(direction), new MathContext(50));
    }

    /** C.2 row 17: what has no direction or is not finite hits nothing, wherever it starts. */
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
