package nephele.editor.brush;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.level.BoxFace;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/**
 * The convex hull of a few hundred points. Every triple is tried, from the largest triangle on; points near its plane
 * are on it, so that faces of four and more corners stay whole.
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
     */
    record Side(Plane plane, BitSet on) {}

    private record Candidate(Plane plane, BitSet on, double doubledArea) {}

    private final List<Vec3> points;
    private final double tolerance;
    private final Map<BitSet, Candidate> candidates = new HashMap<>();

    private ConvexHull(List<Vec3> points) {
        this.points = points;
        tolerance = tolerance(points);
    }

    /** Returns the sides; none if the points are on one plane. */
    static List<Side> of(List<Vec3> points) {
        ConvexHull hull = new ConvexHull(points);
        for (int i = 0; i < points.size(); i++) {
            for (int j = i + 1; j < points.size(); j++) {
                for (int k = j + 1; k < points.size(); k++) {
                    hull.tryTriangle(i, j, k);
                }
            }
        }
        return hull.sides();
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

    private void tryTriangle(int i, int j, int k) {
        Vec3 a = points.get(i);
        Vec3 ab = points.get(j).minus(a);
        Vec3 ac = points.get(k).minus(a);
        Vec3 cross = ab.cross(ac);
        double doubledArea = cross.length();
        double longest =
                Math.max(ab.length(), Math.max(ac.length(), ac.minus(ab).length()));
        if (!(doubledArea > tolerance * longest)) {
            return;
        }
        Vec3 normal = cross.scaled(1 / doubledArea);
        boolean isFront = false;
        boolean isBehind = false;
        for (Vec3 p : points) {
            double distance = normal.dot(p.minus(a));
            isFront |= distance > tolerance;
            isBehind |= distance < -tolerance;
            if (isFront && isBehind) {
                return;
            }
        }
        if (isFront || isBehind) {
            add(isFront ? normal.negated() : normal, a, doubledArea);
        }
    }

    private void add(Vec3 normal, Vec3 a, double doubledArea) {
        BitSet on = new BitSet(points.size());
        for (int i = 0; i < points.size(); i++) {
            on.set(i, Math.abs(normal.dot(points.get(i).minus(a))) <= tolerance);
        }
        Candidate known = candidates.get(on);
        if (known == null || known.doubledArea < doubledArea) {
            candidates.put(on, new Candidate(plane(normal, a, on), on, doubledArea));
        }
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
        List<Candidate> largestFirst = new ArrayList<>(candidates.values());
        largestFirst.sort(
                Comparator.comparingDouble((Candidate c) -> -c.doubledArea).thenComparing(c -> c.on.toString()));
        List<Side> sides = new ArrayList<>();
        for (Candidate candidate : largestFirst) {
            if (sides.stream().noneMatch(side -> isSame(side, candidate))) {
                sides.add(new Side(candidate.plane, candidate.on));
            }
        }
        return sides;
    }

    /** Two sides share an edge at most; candidates that share more are the same side within the tolerance. */
    private boolean isSame(Side side, Candidate candidate) {
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
