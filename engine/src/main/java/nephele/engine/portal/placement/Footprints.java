package nephele.engine.portal.placement;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import nephele.engine.math.Vec3;

/** Computes the part of a convex shape in the thin slab in front of a plane, projected along the plane's normal. */
final class Footprints {
    private record Point(double x, double y) {}

    private Footprints() {}

    /**
     * Returns the footprint.
     *
     * @param loops the outlines of the shape's faces
     * @return {@code null} if nothing reaches into the slab
     */
    static ConvexPolygon of(PlaneFrame frame, List<List<Vec3>> loops, double lowMetres, double highMetres) {
        List<Point> points = new ArrayList<>();
        boolean reaches = false;
        for (List<Vec3> loop : loops) {
            for (int i = 0; i < loop.size(); i++) {
                Vec3 a = loop.get(i);
                Vec3 b = loop.get((i + 1) % loop.size());
                double heightA = frame.height(a);
                double heightB = frame.height(b);
                reaches |= Math.min(heightA, heightB) < highMetres && Math.max(heightA, heightB) > lowMetres;
                if (heightA >= lowMetres && heightA <= highMetres) {
                    points.add(new Point(frame.x(a), frame.y(a)));
                }
                cut(points, frame, a, b, lowMetres);
                cut(points, frame, a, b, highMetres);
            }
        }
        return reaches && points.size() > 1 ? hull(points) : null;
    }

    private static void cut(List<Point> points, PlaneFrame frame, Vec3 a, Vec3 b, double height) {
        double fromA = height - frame.height(a);
        double fromB = height - frame.height(b);
        if (fromA < 0 == fromB < 0) {
            return;
        }
        double share = fromA / (fromA - fromB);
        points.add(new Point(
                frame.x(a) + share * (frame.x(b) - frame.x(a)), frame.y(a) + share * (frame.y(b) - frame.y(a))));
    }

    /**
     * Returns the convex hull (Andrew 1979, "Another efficient algorithm for convex hulls in two dimensions": lower and
     * upper chain).
     */
    private static ConvexPolygon hull(List<Point> points) {
        points.sort(Comparator.comparingDouble(Point::x).thenComparingDouble(Point::y));
        List<Point> hull = new ArrayList<>();
        for (Point p : points) {
            push(hull, p, 0);
        }
        int lower = hull.size() - 1;
        for (int i = points.size() - 2; i >= 0; i--) {
            push(hull, points.get(i), lower);
        }
        double[] corners = new double[2 * Math.max(1, hull.size() - 1)];
        for (int i = 0; 2 * i < corners.length; i++) {
            corners[2 * i] = hull.get(i).x();
            corners[2 * i + 1] = hull.get(i).y();
        }
        ConvexPolygon polygon = ConvexPolygon.of(corners);
        return polygon.corners() < 2 ? null : polygon;
    }

    private static void push(List<Point> hull, Point p, int first) {
        while (hull.size() >= first + 2 && turn(hull.get(hull.size() - 2), hull.get(hull.size() - 1), p) <= 0) {
            hull.remove(hull.size() - 1);
        }
        hull.add(p);
    }

    private static double turn(Point a, Point b, Point c) {
        return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    }
}
