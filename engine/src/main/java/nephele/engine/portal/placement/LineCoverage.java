package nephele.engine.portal.placement;

import nephele.engine.math.Aabb;

/**
 * A segment in a plane, and its parts in or near convex polygons; positions along it are metres from (x, y) in the unit
 * direction (dx, dy).
 */
record LineCoverage(double x, double y, double dx, double dy, double length) {
    static LineCoverage beyond(ConvexPolygon polygon, int edge, double metres) {
        double nx = polygon.normalX(edge);
        double ny = polygon.normalY(edge);
        return new LineCoverage(
                polygon.x(edge) + metres * nx, polygon.y(edge) + metres * ny, -ny, nx, polygon.length(edge));
    }

    /** Returns a segment to the right, which is out of the polygon. */
    LineCoverage outFrom(double along, double metres) {
        return new LineCoverage(atX(along), atY(along), dy, -dx, metres);
    }

    Aabb bounds() {
        double endX = x + length * dx;
        double endY = y + length * dy;
        return new Aabb(Math.min(x, endX), Math.min(y, endY), 0, Math.max(x, endX), Math.max(y, endY), 0);
    }

    double atX(double along) {
        return x + along * dx;
    }

    double atY(double along) {
        return y + along * dy;
    }

    /** Returns the interval inside a polygon; {@code null} for none. */
    double[] within(ConvexPolygon polygon) {
        return polygon.corners() < 3 ? null : inside(polygon);
    }

    /** Returns the interval at most {@code metres} from a polygon; {@code null} for none. */
    double[] near(ConvexPolygon polygon, double metres) {
        double[] span = inside(polygon);
        for (int edge = 0; edge < polygon.corners(); edge++) {
            span = union(span, besideEdge(polygon, edge, metres));
            span = union(span, aroundCorner(polygon.x(edge), polygon.y(edge), metres));
        }
        return span == null || span[1] <= 0 || span[0] >= length ? null : span;
    }

    /** Returns the union, which is one interval because the shape is convex. */
    private static double[] union(double[] a, double[] b) {
        if (a == null || b == null) {
            return a == null ? b : a;
        }
        return new double[] {Math.min(a[0], b[0]), Math.max(a[1], b[1])};
    }

    private double[] inside(ConvexPolygon polygon) {
        double[] span = {Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY};
        for (int i = 0; i < polygon.corners() && span != null; i++) {
            span = clipped(span, polygon.normalX(i), polygon.normalY(i), polygon.distance(i));
        }
        return span;
    }

    private double[] besideEdge(ConvexPolygon polygon, int edge, double metres) {
        double nx = polygon.normalX(edge);
        double ny = polygon.normalY(edge);
        double d = polygon.distance(edge);
        double start = nx * polygon.y(edge) - ny * polygon.x(edge);
        double[] span = {Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY};
        span = clipped(span, nx, ny, d + metres);
        span = clipped(span, -nx, -ny, metres - d);
        span = clipped(span, ny, -nx, -start);
        return clipped(span, -ny, nx, start + polygon.length(edge));
    }

    /** Returns the part with nx · x + ny · y ≤ d. */
    private double[] clipped(double[] span, double nx, double ny, double d) {
        if (span == null) {
            return null;
        }
        double rate = nx * dx + ny * dy;
        double behind = d - (nx * x + ny * y);
        if (rate == 0) {
            return behind >= 0 ? span : null;
        }
        double at = behind / rate;
        double from = rate < 0 ? Math.max(span[0], at) : span[0];
        double to = rate > 0 ? Math.min(span[1], at) : span[1];
        return from <= to ? new double[] {from, to} : null;
    }

    private double[] aroundCorner(double cornerX, double cornerY, double metres) {
        double along = (cornerX - x) * dx + (cornerY - y) * dy;
        double off = (cornerY - y) * dx - (cornerX - x) * dy;
        double square = metres * metres - off * off;
        if (square < 0) {
            return null;
        }
        double half = Math.sqrt(square);
        return new double[] {along - half, along + half};
    }
}
