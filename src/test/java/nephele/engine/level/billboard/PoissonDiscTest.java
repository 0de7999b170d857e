package nephele.engine.level.billboard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.math.Aabb;
import org.junit.jupiter.api.Test;

class PoissonDiscTest {
    private static final Aabb AREA = new Aabb(-20, 0, -10, 20, 0, 10);

    private static List<double[]> points(double spacing, int most, int seed) {
        return PoissonDisc.points(AREA, spacing, most, seed, (x, z, chance) -> true);
    }

    private static double nearest(List<double[]> points) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < points.size(); i++) {
            for (int j = 0; j < i; j++) {
                double dx = points.get(i)[0] - points.get(j)[0];
                double dz = points.get(i)[1] - points.get(j)[1];
                nearest = Math.min(nearest, Math.hypot(dx, dz));
            }
        }
        return nearest;
    }

    @Test
    void keepsTheDistanceInEveryField() {
        for (int seed = 0; seed < 40; seed++) {
            double spacing = 0.7 + 0.11 * seed;
            List<double[]> all = points(spacing, 1000, seed);
            assertTrue(nearest(all) >= spacing, "seed " + seed);
            for (double[] p : all) {
                assertTrue(Math.abs(p[0]) <= 20 && Math.abs(p[1]) <= 10);
            }
        }
    }

    /** Discs thrown at random cover 0.547 of the plane when no other fits (Feder 1980). */
    @Test
    void fillsTheAreaWhenMoreIsAskedForThanFits() {
        List<double[]> all = points(1, 10_000, 3);
        double covered = all.size() * Math.PI / 4 / (41 * 21);
        assertTrue(covered > 0.47 && covered < 0.547, "covered " + covered);
    }

    @Test
    void fewPointsAreSpreadOverAll() {
        int[] quarters = new int[4];
        points(0.2, 800, 5).forEach(p -> quarters[(p[0] > 0 ? 1 : 0) + (p[1] > 0 ? 2 : 0)]++);
        for (int count : quarters) {
            assertEquals(200, count, 45);
        }
    }

    @Test
    void followsTheChoice() {
        List<double[]> all = PoissonDisc.points(AREA, 0.1, 2000, 9, (x, z, chance) -> chance < (x + 20) / 40);
        long right = all.stream().filter(p -> p[0] > 0).count();
        assertEquals(2000, all.size());
        assertEquals(0.75, right / 2000.0, 0.04);
    }

    /** The sum is of this platform and of every other one. */
    @Test
    void isTheSameOnEveryMachine() {
        double sum = 0;
        for (double[] p : points(0.5, 700, 11)) {
            sum = 31 * (sum % 1000) + p[0] + 3 * p[1];
        }
        assertEquals(points(0.5, 700, 11).get(699)[0], points(0.5, 700, 11).get(699)[0]);
        assertEquals(EXPECTED, sum);
    }

    private static final double EXPECTED = 9326.873145103455;

    @Test
    void anEmptyAreaHasNoPoints() {
        assertEquals(List.of(), PoissonDisc.points(new Aabb(1, 0, 1, 1, 0, 5), 1, 9, 0, (x, z, chance) -> true));
    }
}
