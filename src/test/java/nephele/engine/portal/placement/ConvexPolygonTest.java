package nephele.engine.portal.placement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import nephele.engine.level.PortalShape;
import nephele.engine.portal.Aperture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

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

    /** Each corner is right · x + up · y in the plane, reflected; right is a quarter turn clockwise of up. */
    @ParameterizedTest
    @EnumSource(PortalShape.class)
    void aReflectedAperturesCornersAreTurnedAndReflected(PortalShape shape) {
        Aperture aperture = Aperture.of(shape, 1.2, 2.1);
        for (double angle = -3; angle < 3.2; angle += 0.37) {
            double upX = -Math.sin(angle);
            double upY = Math.cos(angle);
            var turned = ConvexPolygon.reflected(aperture, upX, upY);
            assertEquals(aperture.corners(), turned.corners());
            double farX = 0;
            double farY = 0;
            for (int i = 0; i < aperture.corners(); i++) {
                double x = aperture.cornerX(i) * Math.cos(angle) - aperture.cornerY(i) * Math.sin(angle);
                double y = aperture.cornerX(i) * Math.sin(angle) + aperture.cornerY(i) * Math.cos(angle);
                farX = Math.max(farX, Math.abs(x));
                farY = Math.max(farY, Math.abs(y));
                assertTrue(hasCorner(turned, -x, -y), shape + " turned by " + angle + ", corner " + i);
            }
            assertEquals(farX, Math.max(turned.bounds().maxX(), -turned.bounds().minX()), 1e-12);
            assertEquals(farY, Math.max(turned.bounds().maxY(), -turned.bounds().minY()), 1e-12);
        }
    }

    private static boolean hasCorner(ConvexPolygon turned, double x, double y) {
        for (int i = 0; i < turned.corners(); i++) {
            if (Math.hypot(turned.x(i) - x, turned.y(i) - y) < 1e-12) {
                return true;
            }
        }
        return false;
    }
}
