package nephele.workshop.prove.geometry;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;

/**
 * Compares the ray–box test with exact intervals, for rays with components of ±0, subnormal and huge ones, many along a
 * face of the box.
 */
final class ExactSlabs {
    private static final double[] COMPONENTS = {
        0, -0.0, 1, -1, 0.5, -2, Double.MIN_VALUE, -Double.MIN_VALUE, 1e-310, 1e300, -1e300, 1e-30
    };
    private static final double[] PLACES = {0, -0.0, 1, -1, 2, -2, 0.5, 3};
    private static final BigDecimal LARGEST = new BigDecimal(Double.MAX_VALUE);
    private static final double WIDTH_OF_ROUNDING = 1e-12;

    private final List<String> failures;
    private long met;

    ExactSlabs(List<String> failures) {
        this.failures = failures;
    }

    void cast(long unit) {
        var random = new SplittableRandom(unit);
        double[] o = {pick(random, PLACES), pick(random, PLACES), pick(random, PLACES)};
        double[] d = {pick(random, COMPONENTS), pick(random, COMPONENTS), pick(random, COMPONENTS)};
        var box = new Aabb(-1, -1, -1, 1, random.nextInt(3) - 1, 1);
        double entry = new Ray(o[0], o[1], o[2], d[0], d[1], d[2]).boxEntry(box, Double.POSITIVE_INFINITY);
        boolean meets = entry < Double.POSITIVE_INFINITY;
        met += meets ? 1 : 0;
        boolean exact = meets(o, d, box);
        if (exact != meets && !(meets && meets(o, d, box.grown(WIDTH_OF_ROUNDING)))) {
            failures.add("ray " + unit + " from " + Arrays.toString(o) + " along " + Arrays.toString(d) + ": " + entry);
        }
    }

    private static double pick(SplittableRandom random, double[] values) {
        return values[random.nextInt(values.length)];
    }

    /**
     * Intersects the three intervals of the ray parameter. A zero direction has no hit, nor has one beyond the range of
     * double.
     */
    private static boolean meets(double[] o, double[] d, Aabb box) {
        double[] low = {box.minX(), box.minY(), box.minZ()};
        double[] high = {box.maxX(), box.maxY(), box.maxZ()};
        BigDecimal enter = BigDecimal.ZERO;
        BigDecimal leave = null;
        for (int axis = 0; axis < 3; axis++) {
            if (d[axis] == 0 && (o[axis] < low[axis] || o[axis] > high[axis])) {
                return false;
            }
            if (d[axis] != 0) {
                BigDecimal last = parameter(d[axis] > 0 ? high[axis] : low[axis], o[axis], d[axis]);
                enter = enter.max(parameter(d[axis] > 0 ? low[axis] : high[axis], o[axis], d[axis]));
                leave = leave == null ? last : leave.min(last);
            }
        }
        return leave != null && enter.compareTo(leave) <= 0 && enter.compareTo(LARGEST) <= 0;
    }

    private static BigDecimal parameter(double bound, double origin, double direction) {
        return new BigDecimal(bound)
                .subtract(new BigDecimal(origin))
                .divide(new BigDecimal(direction), new MathContext(50));
    }

    long met() {
        return met;
    }
}
