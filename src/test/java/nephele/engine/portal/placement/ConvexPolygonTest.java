package nephele.engine.portal.placement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class ConvexPolygonTest {
    private static final double[] CORNERS = {0, 0, 3, 0, 4, 1, 2, 3, 0.5, 2};

    /** The result equals the distance from every edge's nearest point. */
    @Test
    void whatIsNearAnEdgeOrACornerIsWithinItsDistance() {
        ConvexPolygon polygon = ConvexPolygon.of(CORNERS);
        var random = new SplittableRandom(6);
        int near = 0;
        for (int i = 0; i < 20_000; i++) {
            double x = random.nextDouble(-2, 6);
            double y = random.nextDouble(-2, 5);
            double metres = random.nextDouble(0, 1);
            boolean inside = polygon.outside(x, y) <= 0;
            double distance = inside ? 0 : distance(x, y);
            if (Math.abs(distance - metres) > 1e-9) {
                assertEquals(distance < metres, polygon.isWithin(metres, x, y), x + ", " + y + " within " + metres);
                near += !inside && distance < metres ? 1 : 0;
            }
        }
        assertTrue(near > 2000, "near " + near);
    }

    private static double distance(double x, double y) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < CORNERS.length; i += 2) {
            int j = (i + 2) % CORNERS.length;
            double dx = CORNERS[j] - CORNERS[i];
            double dy = CORNERS[j + 1] - CORNERS[i + 1];
            double along = ((x - CORNERS[i]) * dx + (y - CORNERS[i + 1]) * dy) / (dx * dx + dy * dy);
            double share = Math.max(0, Math.min(1, along));
            least = Math.min(least, Math.hypot(x - CORNERS[i] - share * dx, y - CORNERS[i + 1] - share * dy));
        }
        return least;
    }
}
