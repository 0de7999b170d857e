package nephele.engine.portal.placement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.level.PortalShape;
import nephele.engine.portal.Aperture;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class ReflectedApertureTest {
    /** Each corner is right · x + up · y in the plane, reflected; right is a quarter turn clockwise of up. */
    @ParameterizedTest
    @EnumSource(PortalShape.class)
    void itsCornersAreTheAperturesTurnedAndReflected(PortalShape shape) {
        Aperture aperture = Aperture.of(shape, 1.2, 2.1);
        for (double angle = -3; angle < 3.2; angle += 0.37) {
            double upX = -Math.sin(angle);
            double upY = Math.cos(angle);
            var turned = new ReflectedAperture(aperture, upX, upY);
            assertEquals(aperture.corners(), turned.corners());
            double farX = 0;
            double farY = 0;
            for (int i = 0; i < aperture.corners(); i++) {
                double x = aperture.cornerX(i) * Math.cos(angle) - aperture.cornerY(i) * Math.sin(angle);
                double y = aperture.cornerX(i) * Math.sin(angle) + aperture.cornerY(i) * Math.cos(angle);
                farX = Math.max(farX, Math.abs(x));
                farY = Math.max(farY, Math.abs(y));
                assertTrue(hasCorner(turned, -x, -y), shape + " turned by " + angle + ", corner " + i);
                assertTrue(turned.y(0) <= turned.y(i), "the lowest comes first");
            }
            assertEquals(farX, turned.reachX(), 1e-12);
            assertEquals(farY, turned.reachY(), 1e-12);
        }
    }

    private static boolean hasCorner(ReflectedAperture turned, double x, double y) {
        for (int i = 0; i < turned.corners(); i++) {
            if (Math.hypot(turned.x(i) - x, turned.y(i) - y) < 1e-12) {
                return true;
            }
        }
        return false;
    }
}
