package nephele.engine.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class WatertightRayTest {
    private final TriangleHit hit = new TriangleHit();

    private static double[] triangle(Vec3 a, Vec3 b, Vec3 c) {
        return new double[] {a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), c.x(), c.y(), c.z()};
    }

    @Test
    void distanceSidesAndLimitAreRight() {
        double[] corners = triangle(new Vec3(0, 0, -5), new Vec3(4, 0, -5), new Vec3(0, 4, -5));
        var ahead = new WatertightRay(new Ray(1, 1, 0, 0, 0, -2));
        assertTrue(ahead.intersects(corners, 0, 10, hit));
        assertEquals(2.5, hit.distance(), 0);
        assertEquals(new Vec3(1, 1, -5), hit.point(corners, 0));
        assertEquals(0.5, hit.weightA(), 1e-15);
        assertFalse(ahead.intersects(corners, 0, 2.4, hit));
        assertTrue(new WatertightRay(new Ray(1, 1, -9, 0, 0, 1)).intersects(corners, 0, 10, hit));
        assertFalse(new WatertightRay(new Ray(1, 1, 0, 0, 0, 1)).intersects(corners, 0, 10, hit));
        assertFalse(new WatertightRay(new Ray(3, 3, 0, 0, 0, -1)).intersects(corners, 0, 10, hit));
        assertFalse(new WatertightRay(new Ray(-1, 1, -5, 1, 0, 0)).intersects(corners, 0, 10, hit));
        assertFalse(new WatertightRay(new Ray(1, 1, 0, 0, 0, 0)).intersects(corners, 0, 10, hit));
        assertFalse(new WatertightRay(new Ray(1, 1, 0, Double.NaN, 0, -1)).intersects(corners, 0, 10, hit));
    }
}
