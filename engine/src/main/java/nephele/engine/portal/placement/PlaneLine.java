package nephele.engine.portal.placement;

import nephele.engine.math.Aabb;

/**
 * A segment of a line in a plane. Positions along the line are metres from (x, y) in the unit direction (dx, dy), offsets
 * are metres to its left; intervals are pairs of positions.
 */
record PlaneLine(double x, double y, double dx, double dy, double length) {
    /** Returns an edge of a polygon, moved outwards. */
    static PlaneLine beyond(ConvexPolygon polygon, int edge, double metres) {
        double nx = polygon.normalX(edge);
        double ny = polygon.normalY(edge);
        return new PlaneLine(
                polygon.x(edge) + metres * nx, polygon.y(edge) + metres * ny, -ny, nx, polygon.length(edge));
    }

    /** Returns a segment to the right, which is out of the polygon. */
    PlaneLine outFrom(double along, double metres) {
        return new PlaneLine(atX(along), atY(along), dy, -dx, metres);
    }

    /** Returns a line through a point of this one, with a slope against it. */
    PlaneLine moved(double along, double off, double slope) {
        double unit = Math.sqrt(1 + slope * slope);
        return new PlaneLine(
                atX(along, off), atY(along, off), (dx - slope * dy) / unit, (dy + slope * dx) / unit, length);
    }

    /** Returns the position of a polygon's corner. */
    double along(ConvexPolygon polygon, int corner) {
        return (polygon.x(corner) - x) * dx + (polygon.y(corner) - y) * dy;
    }

    /** Returns the offset of a polygon's corner. */
    double off(ConvexPolygon polygon, int corner) {
        return (polygon.y(corner) - y) * dx - (polygon.x(corner) - x) * dy;
    }

    /** Returns the interval between the ends of another segment. */
    double[] span(ConvexPolygon segment) {
        double a = along(segment, 0);
        double b = along(segment, 1);
        return new double[] {Math.min(a, b), Math.max(a, b)};
    }

    /** Returns the cosine of the angle to another segment. */
    double cosine(ConvexPolygon segment) {
        return -segment.normalY(0) * dx + segment.normalX(0) * dy;
    }

    /** Returns the bounds of an interval. */
    Aabb bounds(double from, double to) {
        double fromX = atX(from);
        double fromY = atY(from);
        double toX = atX(to);
        double toY = atY(to);
        return new Aabb(Math.min(fromX, toX), Math.min(fromY, toY), 0, Math.max(fromX, toX), Math.max(fromY, toY), 0);
    }

    Aabb bounds() {
        return bounds(0, length);
    }

    double atX(double along) {
        return x + along * dx;
    }

    double atY(double along) {
        return y + along * dy;
    }

    double atX(double along, double off) {
        return x + along * dx - off * dy;
    }

    double atY(double along, double off) {
        return y + along * dy + off * dx;
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

    /** Returns the least interval that holds both; of {@code null} and another one the other. */
    static double[] union(double[] a, double[] b) {
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
