package nephele.engine.portal.placement;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;

/**
 * A convex polygon in a plane, corners counter-clockwise, in metres. Two corners make a segment, whose edges are its
 * two sides.
 */
final class ConvexPolygon {
    /** Least length of an edge with a direction; shorter ones are removed. */
    private static final double LEAST_EDGE = 1e-12;

    private final double[] corners;
    /** For each edge: outward unit normal x, y, distance from the origin, length. */
    private final double[] edges;

    private ConvexPolygon(double[] corners) {
        this.corners = corners;
        edges = edges(corners);
    }

    /** @param corners x, y of each; repeated ones are removed */
    static ConvexPolygon of(double[] corners) {
        double[] kept = new double[corners.length];
        int size = 0;
        for (int i = 0; i < corners.length; i += 2) {
            int j = (i + 2) % corners.length;
            double dx = corners[j] - corners[i];
            double dy = corners[j + 1] - corners[i + 1];
            if (dx * dx + dy * dy > LEAST_EDGE * LEAST_EDGE) {
                kept[size++] = corners[i];
                kept[size++] = corners[i + 1];
            }
        }
        return new ConvexPolygon(size == corners.length ? corners : Arrays.copyOf(kept, size));
    }

    /** Returns a polygon of the world in a plane's coordinates. */
    static ConvexPolygon of(PlaneFrame frame, List<Vec3> polygon) {
        double[] corners = new double[2 * polygon.size()];
        for (int i = 0; i < polygon.size(); i++) {
            corners[2 * i] = frame.x(polygon.get(i));
            corners[2 * i + 1] = frame.y(polygon.get(i));
        }
        return of(corners);
    }

    /**
     * Returns an aperture in a plane's frame, reflected at its centre: its Minkowski sum with an obstacle is the set of
     * centres at which the aperture would reach the obstacle.
     *
     * @param upX,upY the aperture's up in the plane's frame, of unit length
     */
    static ConvexPolygon reflected(Aperture aperture, double upX, double upY) {
        double[] corners = new double[2 * aperture.corners()];
        for (int i = 0; i < aperture.corners(); i++) {
            corners[2 * i] = -(aperture.cornerX(i) * upY + aperture.cornerY(i) * upX);
            corners[2 * i + 1] = -(aperture.cornerY(i) * upY - aperture.cornerX(i) * upX);
        }
        return of(corners);
    }

    /**
     * Returns the part of a convex shape in a thin slab in front of a plane, projected along the plane's normal.
     *
     * @param loops the outlines of the shape's faces
     * @return {@code null} if nothing reaches into the slab
     */
    static ConvexPolygon footprint(PlaneFrame frame, List<List<Vec3>> loops, double lowMetres, double highMetres) {
        List<double[]> points = new ArrayList<>();
        boolean reaches = false;
        for (List<Vec3> loop : loops) {
            for (int i = 0; i < loop.size(); i++) {
                Vec3 a = loop.get(i);
                Vec3 b = loop.get((i + 1) % loop.size());
                double heightA = frame.height(a);
                double heightB = frame.height(b);
                reaches |= Math.min(heightA, heightB) < highMetres && Math.max(heightA, heightB) > lowMetres;
                if (heightA >= lowMetres && heightA <= highMetres) {
                    points.add(new double[] {frame.x(a), frame.y(a)});
                }
                cut(points, frame, a, b, lowMetres);
                cut(points, frame, a, b, highMetres);
            }
        }
        return reaches && points.size() > 1 ? hull(points) : null;
    }

    private static void cut(List<double[]> points, PlaneFrame frame, Vec3 a, Vec3 b, double height) {
        double fromA = height - frame.height(a);
        double fromB = height - frame.height(b);
        if (fromA < 0 == fromB < 0) {
            return;
        }
        double fraction = fromA / (fromA - fromB);
        points.add(new double[] {
            frame.x(a) + fraction * (frame.x(b) - frame.x(a)), frame.y(a) + fraction * (frame.y(b) - frame.y(a))
        });
    }

    /**
     * Returns the convex hull (Andrew 1979, "Another efficient algorithm for convex hulls in two dimensions": lower and
     * upper chain).
     */
    private static ConvexPolygon hull(List<double[]> points) {
        points.sort(Arrays::compare);
        List<double[]> hull = new ArrayList<>();
        for (double[] p : points) {
            push(hull, p, 0);
        }
        int lower = hull.size() - 1;
        for (int i = points.size() - 2; i >= 0; i--) {
            push(hull, points.get(i), lower);
        }
        double[] corners = new double[2 * Math.max(1, hull.size() - 1)];
        for (int i = 0; 2 * i < corners.length; i++) {
            System.arraycopy(hull.get(i), 0, corners, 2 * i, 2);
        }
        ConvexPolygon polygon = of(corners);
        return polygon.corners() < 2 ? null : polygon;
    }

    private static void push(List<double[]> hull, double[] p, int first) {
        while (hull.size() >= first + 2 && turn(hull.get(hull.size() - 2), hull.get(hull.size() - 1), p) <= 0) {
            hull.remove(hull.size() - 1);
        }
        hull.add(p);
    }

    private static double turn(double[] a, double[] b, double[] c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }

    private static double[] edges(double[] corners) {
        double[] edges = new double[2 * corners.length];
        for (int i = 0; i < corners.length; i += 2) {
            int j = (i + 2) % corners.length;
            double dx = corners[j] - corners[i];
            double dy = corners[j + 1] - corners[i + 1];
            double length = Math.sqrt(dx * dx + dy * dy);
            edges[2 * i] = dy / length;
            edges[2 * i + 1] = -dx / length;
            edges[2 * i + 2] = edges[2 * i] * corners[i] + edges[2 * i + 1] * corners[i + 1];
            edges[2 * i + 3] = length;
        }
        return edges;
    }

    int corners() {
        return corners.length / 2;
    }

    double x(int corner) {
        return corners[2 * corner];
    }

    double y(int corner) {
        return corners[2 * corner + 1];
    }

    double normalX(int edge) {
        return edges[4 * edge];
    }

    double normalY(int edge) {
        return edges[4 * edge + 1];
    }

    /** Returns the distance in metres from the origin to the line through an edge. */
    double distance(int edge) {
        return edges[4 * edge + 2];
    }

    double length(int edge) {
        return edges[4 * edge + 3];
    }

    /** Returns the corner with the least y, and among those the least x: edges from there on have growing angles. */
    int lowest() {
        int lowest = 0;
        for (int i = 1; i < corners(); i++) {
            boolean lower = y(i) < y(lowest) || y(i) == y(lowest) && x(i) < x(lowest);
            lowest = lower ? i : lowest;
        }
        return lowest;
    }

    /** Returns true if a direction's angle, from 0 to 2π, is not greater than another's. */
    static boolean isBefore(double ax, double ay, double bx, double by) {
        boolean upperA = ay > 0 || ay == 0 && ax > 0;
        boolean upperB = by > 0 || by == 0 && bx > 0;
        return upperA == upperB ? ax * by - ay * bx >= 0 : upperA;
    }

    Aabb bounds() {
        double minX = Double.POSITIVE_INFINITY;
        double minY = Double.POSITIVE_INFINITY;
        double maxX = Double.NEGATIVE_INFINITY;
        double maxY = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < corners.length; i += 2) {
            minX = Math.min(minX, corners[i]);
            maxX = Math.max(maxX, corners[i]);
            minY = Math.min(minY, corners[i + 1]);
            maxY = Math.max(maxY, corners[i + 1]);
        }
        return new Aabb(minX, minY, 0, maxX, maxY, 0);
    }

    /** Returns the distance in metres of a point outside the farthest edge's line; negative inside. */
    double outside(double x, double y) {
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < edges.length; i += 4) {
            most = Math.max(most, edges[i] * x + edges[i + 1] * y - edges[i + 2]);
        }
        return most;
    }

    /** Returns true if a point is in the polygon or at most {@code metres} away. */
    boolean isWithin(double metres, double x, double y) {
        double outside = outside(x, y);
        if (outside <= 0) {
            return true;
        }
        for (int i = 0; i < corners() && outside <= metres; i++) {
            double dx = x - x(i);
            double dy = y - y(i);
            double past = Math.max(0, Math.max(-along(i, dx, dy), along(i, dx, dy) - length(i)));
            double off = normalX(i) * dx + normalY(i) * dy;
            if (past * past + off * off <= metres * metres) {
                return true;
            }
        }
        return false;
    }

    private double along(int edge, double dx, double dy) {
        return normalX(edge) * dy - normalY(edge) * dx;
    }

    /**
     * Returns the greatest gap between two polygons along the normal of an edge of either; negative for the depth of
     * overlap.
     */
    static double gap(ConvexPolygon a, ConvexPolygon b) {
        return Math.max(a.gapBeyondEdges(b), b.gapBeyondEdges(a));
    }

    private double gapBeyondEdges(ConvexPolygon other) {
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < corners(); i++) {
            double least = Double.POSITIVE_INFINITY;
            for (int k = 0; k < other.corners(); k++) {
                least = Math.min(least, normalX(i) * other.x(k) + normalY(i) * other.y(k) - distance(i));
            }
            most = Math.max(most, least);
        }
        return most;
    }
}
