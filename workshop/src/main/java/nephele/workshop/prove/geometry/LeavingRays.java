package nephele.workshop.prove.geometry;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.TriangleHit;
import nephele.engine.math.Vec3;
import nephele.engine.math.WatertightRay;

/** Casts rays that continue from a point of a triangle of 1 mm to 1000 km, steeply or almost along it. */
final class LeavingRays {
    private final List<String> failures;
    private final TriangleHit hit = new TriangleHit();
    private long walls;

    LeavingRays(List<String> failures) {
        this.failures = failures;
    }

    void cast(long unit) {
        var random = new SplittableRandom(unit);
        double scale = new double[] {1e-3, 1, 100, 1e6}[(int) (unit % 4)];
        double[] corners = corners(random, scale, unit % 3 == 0 ? 1e6 : 10 * scale);
        Vec3 normal = WatertightRay.normal(corners, 0);
        double a = random.nextDouble();
        double b = (1 - a) * random.nextDouble();
        Vec3 out = random.nextBoolean() ? normal : normal.negated();
        Vec3 side = out.cross(direction(random));
        double slope = unit % 2 == 0 ? 1 : StrictMath.pow(10, random.nextDouble(0, 6));
        var onward = out.addScaled(slope, side);
        Vec3 origin = TriangleHit.at(a, b, 1 - a - b).originTowards(onward, corners, 0);
        if (new WatertightRay(Ray.of(origin, onward)).intersects(corners, 0, Double.POSITIVE_INFINITY, hit)) {
            failures.add("ray " + unit + " meets the triangle it leaves, " + hit.distance() + " on");
        }
        if (scale <= 100) {
            castAtWall(unit, origin, out, corners);
        }
    }

    private static double[] corners(SplittableRandom random, double scale, double farOut) {
        Vec3 d = direction(random);
        double[] offset = {farOut * d.x(), farOut * d.y(), farOut * d.z()};
        double[] corners = new double[9];
        for (int k = 0; k < 9; k++) {
            corners[k] = offset[k % 3] + scale * random.nextDouble();
        }
        return corners;
    }

    private static Vec3 direction(SplittableRandom random) {
        return new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
    }

    /**
     * Casts at a wall 1 mm in front of the origin: the ray must hit it, and the origin must be on the triangle's plane.
     */
    private void castAtWall(long unit, Vec3 origin, Vec3 out, double[] corners) {
        Vec3 u = Directions.perpendicular(out);
        Vec3 v = out.cross(u);
        double[] wall = new double[9];
        double[][] at = {{-1, -1}, {3, -1}, {-1, 3}};
        for (int k = 0; k < 3; k++) {
            wall[3 * k] = origin.x() + 1e-3 * out.x() + at[k][0] * u.x() + at[k][1] * v.x();
            wall[3 * k + 1] = origin.y() + 1e-3 * out.y() + at[k][0] * u.y() + at[k][1] * v.y();
            wall[3 * k + 2] = origin.z() + 1e-3 * out.z() + at[k][0] * u.z() + at[k][1] * v.z();
        }
        var moved = new Vec3(origin.x() - corners[0], origin.y() - corners[1], origin.z() - corners[2]);
        boolean within = Math.abs(moved.dot(out)) < 1e-4;
        if (!within || !new WatertightRay(Ray.of(origin, out)).intersects(wall, 0, 1, hit)) {
            failures.add("ray " + unit + " leaks through a wall 1 mm on");
        }
        walls++;
    }

    long walls() {
        return walls;
    }
}
