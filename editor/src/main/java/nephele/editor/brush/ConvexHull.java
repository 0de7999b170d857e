package nephele.editor.brush;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import nephele.engine.level.BoxFace;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/**
 * The convex hull of a few hundred points. Every triple is tried that is not on a known side; points near its plane are
 * on it, so that faces of four and more corners stay whole.
 */
final class ConvexHull {
    /** More points would take more than about a second. */
    static final int MOST_POINTS = 400;

    /** Distance, relative to the extent of the points, below which a point is on a plane. */
    private static final double COPLANAR = 1e-7;

    /** The same, relative to the farthest coordinate: what the engine can tell apart. */
    private static final double ROUNDING = 4e-9;

    /**
     * A side of the hull.
     *
     * @param on indices of the points on the plane
     * @param doubledArea twice the area of the polygon of the points, square metres
     */
    record Side(Plane plane, BitSet on, double doubledArea) {}

    private final List<Vec3> points;
    private final double tolerance;
    private final List<Side> candidates = new ArrayList<>();

    private ConvexHull(List<Vec3> points) {
        this.points = points;
        tolerance = tolerance(points);
    }

    /** Returns the sides; none if the points are on one plane. */
    static List<Side> of(List<Vec3> points) {
        ConvexHull hull = new ConvexHull(points);
        for (int i = 0; i < points.size(); i++) {
            for (int j = i + 1; j < points.size(); j++) {
                BitSet done = hull.onSidesWith(i, j);
                for (int k = done.nextClearBit(j + 1); k < points.size(); k = done.nextClearBit(k + 1)) {
                    if (hull.tryTriangle(i, j, k)) {
                        done = hull.onSidesWith(i, j);
                    }
                }
            }
        }
        return hull.sides();
    }

    /** Returns the points on known sides that hold two points: triangles with them are known, too. */
    private BitSet onSidesWith(int i, int j) {
        BitSet on = new BitSet();
        for (Side known : candidates) {
            if (known.on.get(i) && known.on.get(j)) {
                on.or(known.on);
            }
        }
        return on;
    }

    /** Returns the distance in metres below which a point is on a plane. */
    static double tolerance(List<Vec3> points) {
        double size = 0;
        double farthest = 1;
        for (Vec3 p : points) {
            size = Math.max(size, largest(p.minus(points.get(0))));
            farthest = Math.max(farthest, largest(p));
        }
        return Math.max(COPLANAR * size, ROUNDING * farthest);
    }

    private static double largest(Vec3 v) {
        return Math.max(Math.abs(v.x()), Math.max(Math.abs(v.y()), Math.abs(v.z())));
    }

    /** Adds the side of a triangle that has all points behind it; returns false if there is none. */
    private boolean tryTriangle(int i, int j, int k) {
        Vec3 a = points.get(i);
        Vec3 ab = points.get(j).minus(a);
        Vec3 ac = points.get(k).minus(a);
        Vec3 cross = ab.cross(ac);
        double doubledArea = cross.length();
        double longest =
                Math.max(ab.length(), Math.max(ac.length(), ac.minus(ab).length()));
        if (!(doubledArea > tolerance * longest)) {
            return false;
        }
        Vec3 normal = cross.scaled(1 / doubledArea);
        boolean isFront = false;
        boolean isBehind = false;
        for (Vec3 p : points) {
            double distance = normal.dot(p.minus(a));
            isFront |= distance > tolerance;
            isBehind |= distance < -tolerance;
            if (isFront && isBehind) {
                return false;
            }
        }
        if (isFront || isBehind) {
            add(isFront ? normal.negated() : normal, a);
        }
        return isFront || isBehind;
    }

    /** Adds the side with the mean normal of the polygon of all points near the plane (Newell's method). */
    private void add(Vec3 normal, Vec3 a) {
        BitSet on = new BitSet(points.size());
        for (int i = 0; i < points.size(); i++) {
            on.set(i, Math.abs(normal.dot(points.get(i).minus(a))) <= tolerance);
        }
        List<Vec3> near = on.stream().mapToObj(points::get).distinct().toList();
        List<Vec3> ring = ConvexPolyhedron.counterClockwise(Plane.through(normal, a), near);
        Vec3 doubledArea = Vec3.ZERO;
        for (int i = 2; i < ring.size(); i++) {
            doubledArea = doubledArea.plus(
                    ring.get(i - 1).minus(ring.get(0)).cross(ring.get(i).minus(ring.get(0))));
        }
        Vec3 mean = Plane.of(doubledArea, 0).normal();
        candidates.add(new Side(plane(mean, ring.get(0), on), on, doubledArea.length()));
    }

    /** A side whose points agree in a coordinate is exactly perpendicular to that axis. */
    private Plane plane(Vec3 normal, Vec3 a, BitSet on) {
        for (BoxFace side : BoxFace.values()) {
            double along = side.normal().dot(a);
            boolean isFlat = normal.dot(side.normal()) > 0.5
                    && on.stream().allMatch(i -> side.normal().dot(points.get(i)) == along);
            if (isFlat) {
                return Plane.through(side.normal(), a);
            }
        }
        return Plane.through(normal, a);
    }

    private List<Side> sides() {
        List<Side> largestFirst = new ArrayList<>(candidates);
        largestFirst.sort(Comparator.comparingDouble((Side side) -> -side.doubledArea));
        List<Side> sides = new ArrayList<>();
        for (Side candidate : largestFirst) {
            if (sides.stream().noneMatch(side -> isSame(side, candidate))) {
                sides.add(candidate);
            }
        }
        return sides;
    }

    /** Two sides share an edge at most; candidates that share more are the same side within the tolerance. */
    private boolean isSame(Side side, Side candidate) {
        BitSet shared = (BitSet) side.on.clone();
        shared.and(candidate.on);
        return side.plane.normal().dot(candidate.plane.normal()) > 0 && isWide(shared);
    }

    /** Returns true if the points are farther from a line than the tolerance. */
    private boolean isWide(BitSet on) {
        List<Vec3> corners = on.stream().mapToObj(points::get).toList();
        if (corners.size() < 3) {
            return false;
        }
        Vec3 a = corners.get(0);
        Vec3 along = Vec3.ZERO;
        for (Vec3 p : corners) {
            along = p.minus(a).length() > along.length() ? p.minus(a) : along;
        }
        for (Vec3 p : corners) {
            if (along.cross(p.minus(a)).length() > 2 * tolerance * along.length()) {
                return true;
            }
        }
        return false;
    }
}
