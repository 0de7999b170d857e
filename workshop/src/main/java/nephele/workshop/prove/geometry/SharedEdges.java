package nephele.workshop.prove.geometry;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.math.Ray;
import nephele.engine.math.TriangleHit;
import nephele.engine.math.Vec3;
import nephele.engine.math.WatertightRay;

/** Casts rays at the spokes and the hub of non-planar fans of triangles, up to 100 km away from the origin. */
final class SharedEdges {
    private static final int SPOKES = 7;
    private static final double MOST_ULPS = 8;

    private final List<String> failures;
    private final TriangleHit hit = new TriangleHit();
    private double greatestUlpsOffPlane;

    SharedEdges(List<String> failures) {
        this.failures = failures;
    }

    void cast(long unit) {
        var random = new SplittableRandom(unit);
        double farOut = new double[] {0, 1e3, 1e5}[(int) (unit % 3)];
        Vec3 hub = new Vec3(farOut + random.nextDouble(), -farOut + random.nextDouble(), random.nextDouble());
        Vec3[] rim = rim(hub, random);
        Vec3 end = rim[(int) (unit % SPOKES)];
        double share = unit % 5 == 0 ? 0 : 0.99 * random.nextDouble();
        Vec3 aim = hub.lerp(end, share);
        Vec3 origin = new Vec3(hub.x() + random.nextDouble(-2, 2), hub.y() + random.nextDouble(-2, 2), 9);
        var direction = aim.minus(origin);
        if (!meetsFan(new WatertightRay(Ray.of(origin, direction)), hub, rim, unit)) {
            failures.add("ray " + unit + " slips through the fan");
        }
    }

    private static Vec3[] rim(Vec3 hub, SplittableRandom random) {
        Vec3[] rim = new Vec3[SPOKES];
        for (int k = 0; k < SPOKES; k++) {
            double angle = 2 * Math.PI * (k + 0.8 * random.nextDouble()) / SPOKES;
            double radius = random.nextDouble(1, 3);
            rim[k] = new Vec3(
                    hub.x() + radius * Math.cos(angle), hub.y() + radius * Math.sin(angle), random.nextDouble(0.5));
        }
        return rim;
    }

    private boolean meetsFan(WatertightRay ray, Vec3 hub, Vec3[] rim, long unit) {
        boolean met = false;
        for (int k = 0; k < SPOKES; k++) {
            Vec3 b = rim[k];
            Vec3 c = rim[(k + 1) % SPOKES];
            double[] corners = {hub.x(), hub.y(), hub.z(), b.x(), b.y(), b.z(), c.x(), c.y(), c.z()};
            if (ray.intersects(corners, 0, Double.POSITIVE_INFINITY, hit)) {
                met = true;
                measure(corners, unit);
            }
        }
        return met;
    }

    private void measure(double[] corners, long unit) {
        Vec3 point = hit.point(corners, 0);
        Vec3 inPlane = new Vec3(point.x() - corners[0], point.y() - corners[1], point.z() - corners[2]);
        double off = Math.abs(WatertightRay.normal(corners, 0).dot(inPlane));
        double extent = Math.max(Math.abs(point.x()), Math.max(Math.abs(point.y()), 3));
        greatestUlpsOffPlane = Math.max(greatestUlpsOffPlane, off / Math.ulp(extent));
        if (off > MOST_ULPS * Math.ulp(extent)) {
            failures.add("ray " + unit + " hits " + off + " m off the plane");
        }
    }

    double greatestUlpsOffPlane() {
        return greatestUlpsOffPlane;
    }
}
