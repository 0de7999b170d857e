package nephele.workshop.prove.geometry;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.math.Aabb;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.TriangleHit;
import nephele.engine.math.Vec3;
import nephele.engine.math.WatertightRay;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Casts rays where rounding decides: at shared edges and corners, from surfaces, along the faces of boxes. */
public final class RayProof implements Proof {
    private static final int SPOKES = 7;
    private static final double MOST_ULPS = 8;

    private static final double[] COMPONENTS = {
        0, -0.0, 1, -1, 0.5, -2, Double.MIN_VALUE, -Double.MIN_VALUE, 1e-310, 1e300, -1e300, 1e-30
    };
    private static final double[] PLACES = {0, -0.0, 1, -1, 2, -2, 0.5, 3};
    private static final BigDecimal LARGEST = new BigDecimal(Double.MAX_VALUE);
    private static final double WIDTH_OF_ROUNDING = 1e-12;

    @Override
    public Claim claim() {
        return new Claim(
                "rays",
                "No ray passes between triangles that share an edge, hits the surface that it leaves, passes"
                        + " a wall 1 mm away, or misses a box that it hits in exact arithmetic.",
                "rays of each kind",
                1_000_000,
                100_000);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        Casts casts = new Casts();
        for (long unit = from; unit < from + count; unit++) {
            casts.castAtSharedEdge(unit);
            casts.castFromSurface(unit);
            casts.castAtBox(unit);
            progress.unitsDone(unit + 1 - from);
        }
        return ProofResult.of(
                count,
                casts.failures,
                Figure.greatest("farthest hit from its plane", casts.greatestUlpsOffPlane, "ulp of the extent"),
                Figure.sum("walls 1 mm on", casts.walls, ""),
                Figure.sum("boxes met", casts.met, ""));
    }

    /** The rays of a range of units, with what they found. */
    private static final class Casts {
        private final List<String> failures = new ArrayList<>();
        private final TriangleHit hit = new TriangleHit();
        private double greatestUlpsOffPlane;
        private long walls;
        private long met;

        /** Casts a ray at the spokes or the hub of a non-planar fan of triangles, up to 100 km away from the origin. */
        void castAtSharedEdge(long unit) {
            var random = new SplittableRandom(unit);
            double farOut = new double[] {0, 1e3, 1e5}[(int) (unit % 3)];
            Vec3 hub = new Vec3(farOut + random.nextDouble(), -farOut + random.nextDouble(), random.nextDouble());
            Vec3[] rim = rim(hub, random);
            Vec3 end = rim[(int) (unit % SPOKES)];
            double along = unit % 5 == 0 ? 0 : 0.99 * random.nextDouble();
            Vec3 aim = hub.lerp(end, along);
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

        /** Casts a ray that continues from a point of a triangle of 1 mm to 1000 km, steeply or almost along it. */
        void castFromSurface(long unit) {
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

        /**
         * Compares the ray–box test with exact intervals, for rays with components of ±0, subnormal and huge ones, many along
         * a face of the box.
         */
        void castAtBox(long unit) {
            var random = new SplittableRandom(unit);
            double[] o = {pick(random, PLACES), pick(random, PLACES), pick(random, PLACES)};
            double[] d = {pick(random, COMPONENTS), pick(random, COMPONENTS), pick(random, COMPONENTS)};
            var box = new Aabb(-1, -1, -1, 1, random.nextInt(3) - 1, 1);
            double entry = new Ray(o[0], o[1], o[2], d[0], d[1], d[2]).boxEntry(box, Double.POSITIVE_INFINITY);
            boolean meets = entry < Double.POSITIVE_INFINITY;
            met += meets ? 1 : 0;
            boolean exact = meets(o, d, box);
            if (exact != meets && !(meets && meets(o, d, box.grown(WIDTH_OF_ROUNDING)))) {
                failures.add(
                        "ray " + unit + " from " + Arrays.toString(o) + " along " + Arrays.toString(d) + ": " + entry);
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
    }
}
