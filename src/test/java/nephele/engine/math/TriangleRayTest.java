package nephele.engine.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class TriangleRayTest {
    private final TriangleHit hit = new TriangleHit();

    private static double[] triangle(Vec3 a, Vec3 b, Vec3 c) {
        return new double[] {a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), c.x(), c.y(), c.z()};
    }

    private static Vec3 mix(Vec3 a, Vec3 b, double t) {
        return new Vec3(a.x() + t * (b.x() - a.x()), a.y() + t * (b.y() - a.y()), a.z() + t * (b.z() - a.z()));
    }

    private static Vec3 from(Vec3 a, Vec3 b) {
        return new Vec3(b.x() - a.x(), b.y() - a.y(), b.z() - a.z());
    }

    private static Vec3 scaled(Vec3 v, double s) {
        return new Vec3(v.x() * s, v.y() * s, v.z() * s);
    }

    /**
     * C.2 row 15, at a reduced count: rays at the spokes and the hub of a fan always hit it. The fan is not flat and
     * lies up to 100 km away from the origin.
     */
    @Test
    void noRaySlipsBetweenTrianglesThatShareAnEdgeOrACorner() {
        var random = new SplittableRandom(15);
        int missed = 0;
        for (int i = 0; i < 40_000; i++) {
            double farOut = new double[] {0, 1e3, 1e5}[i % 3];
            Vec3 hub = new Vec3(farOut + random.nextDouble(), -farOut + random.nextDouble(), random.nextDouble());
            Vec3[] rim = new Vec3[7];
            for (int k = 0; k < rim.length; k++) {
                double angle = 2 * Math.PI * (k + 0.8 * random.nextDouble()) / rim.length;
                double radius = random.nextDouble(1, 3);
                rim[k] = new Vec3(
                        hub.x() + radius * Math.cos(angle), hub.y() + radius * Math.sin(angle), random.nextDouble(0.5));
            }
            Vec3 aim = i % 5 == 0 ? hub : mix(hub, rim[i % rim.length], 0.99 * random.nextDouble());
            Vec3 origin = new Vec3(hub.x() + random.nextDouble(-2, 2), hub.y() + random.nextDouble(-2, 2), 9);
            TriangleRay ray = new TriangleRay(Ray.of(origin, from(origin, aim)));
            boolean met = false;
            for (int k = 0; k < rim.length; k++) {
                double[] corners = triangle(hub, rim[k], rim[(k + 1) % rim.length]);
                if (ray.meets(corners, 0, Double.POSITIVE_INFINITY, hit)) {
                    met = true;
                    assertOnPlane(corners);
                }
            }
            missed += met ? 0 : 1;
        }
        assertEquals(0, missed);
    }

    /** C.2 row 15: the hit is off the plane by at most 8 ulp of the extent. */
    private void assertOnPlane(double[] corners) {
        Vec3 normal = TriangleRay.normal(corners, 0);
        Vec3 point = hit.point(corners, 0);
        double off = normal.x() * (point.x() - corners[0])
                + normal.y() * (point.y() - corners[1])
                + normal.z() * (point.z() - corners[2]);
        double extent = Math.max(Math.abs(point.x()), Math.max(Math.abs(point.y()), 3));
        assertTrue(Math.abs(off) <= 8 * Math.ulp(extent), () -> off + " m off the plane, " + extent + " m out");
        assertEquals(1, hit.weightA() + hit.weightB() + hit.weightC(), 1e-14);
    }

    @Test
    void distanceSidesAndLimitAreRight() {
        double[] corners = triangle(new Vec3(0, 0, -5), new Vec3(4, 0, -5), new Vec3(0, 4, -5));
        var ahead = new TriangleRay(new Ray(1, 1, 0, 0, 0, -2));
        assertTrue(ahead.meets(corners, 0, 10, hit));
        assertEquals(2.5, hit.distance(), 0);
        assertEquals(new Vec3(1, 1, -5), hit.point(corners, 0));
        assertEquals(0.5, hit.weightA(), 1e-15);
        assertFalse(ahead.meets(corners, 0, 2.4, hit));
        assertTrue(new TriangleRay(new Ray(1, 1, -9, 0, 0, 1)).meets(corners, 0, 10, hit));
        assertFalse(new TriangleRay(new Ray(1, 1, 0, 0, 0, 1)).meets(corners, 0, 10, hit));
        assertFalse(new TriangleRay(new Ray(3, 3, 0, 0, 0, -1)).meets(corners, 0, 10, hit));
        assertFalse(new TriangleRay(new Ray(-1, 1, -5, 1, 0, 0)).meets(corners, 0, 10, hit));
        assertFalse(new TriangleRay(new Ray(1, 1, 0, 0, 0, 0)).meets(corners, 0, 10, hit));
        assertFalse(new TriangleRay(new Ray(1, 1, 0, Double.NaN, 0, -1)).meets(corners, 0, 10, hit));
    }

    /** C.2 row 16, at a reduced count: 0 self-hits, and 0 leaks through a wall 1 mm thick. */
    @Test
    void aRayThatLeavesASurfaceNeitherHitsItAgainNorSkipsAWallOneMillimetreBehind() {
        var random = new SplittableRandom(16);
        int tested = 0;
        for (int i = 0; i < 30_000; i++) {
            double scale = new double[] {1e-3, 1, 100, 1e6}[i % 4];
            Vec3 offset = scaled(BasisTest.randomDirection(random), i % 3 == 0 ? 1e6 : 10 * scale);
            double[] near = new double[9];
            for (int k = 0; k < 9; k++) {
                near[k] =
                        (k % 3 == 0 ? offset.x() : k % 3 == 1 ? offset.y() : offset.z()) + scale * random.nextDouble();
            }
            Vec3 normal = TriangleRay.normal(near, 0);
            double a = random.nextDouble();
            double b = (1 - a) * random.nextDouble();
            hit.set(1, a, b, 1 - a - b);
            Vec3 out = Directions.dot(normal, BasisTest.randomDirection(random)) > 0 ? normal : scaled(normal, -1);
            Vec3 side = Directions.cross(out, BasisTest.randomDirection(random));
            double slope = i % 2 == 0 ? 1 : Math.pow(10, random.nextDouble(0, 6));
            Vec3 direction =
                    new Vec3(out.x() + slope * side.x(), out.y() + slope * side.y(), out.z() + slope * side.z());
            Vec3 origin = hit.originTowards(direction, near, 0);
            TriangleRay ray = new TriangleRay(Ray.of(origin, direction));
            TriangleHit again = new TriangleHit();
            assertFalse(ray.meets(near, 0, Double.POSITIVE_INFINITY, again), "self-hit at " + origin);
            if (scale <= 100 && wallBehindIsMet(near, origin, out)) {
                tested++;
            }
        }
        assertTrue(tested > 10_000, tested + " walls");
    }

    /** A wall 1 mm in front of the point; a ray straight towards it must meet it. */
    private static boolean wallBehindIsMet(double[] corners, Vec3 origin, Vec3 out) {
        Vec3 u = Directions.perpendicular(out);
        Vec3 v = Directions.cross(out, u);
        double[] wall = new double[9];
        double[][] at = {{-1, -1}, {3, -1}, {-1, 3}};
        for (int k = 0; k < 3; k++) {
            wall[3 * k] = origin.x() + 1e-3 * out.x() + at[k][0] * u.x() + at[k][1] * v.x();
            wall[3 * k + 1] = origin.y() + 1e-3 * out.y() + at[k][0] * u.y() + at[k][1] * v.y();
            wall[3 * k + 2] = origin.z() + 1e-3 * out.z() + at[k][0] * u.z() + at[k][1] * v.z();
        }
        assertTrue(new TriangleRay(Ray.of(origin, out)).meets(wall, 0, 1, new TriangleHit()), "leak at " + origin);
        Vec3 corner = new Vec3(corners[0], corners[1], corners[2]);
        assertTrue(Math.abs(Directions.dot(from(corner, origin), out)) < 1e-4, "the offset itself crosses the wall");
        return true;
    }
}
