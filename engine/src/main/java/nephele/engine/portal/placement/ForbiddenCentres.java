package nephele.engine.portal.placement;

import java.util.Arrays;

/**
 * The centres at which an aperture would overlap an obstacle: for each convex obstacle its Minkowski sum with the
 * reflected aperture, a convex polygon. Filled again for every query.
 */
final class ForbiddenCentres {
    private static final double LEAST_EDGE = 1e-12;

    /** Sine of the angle to an outline from which its next part applies; the ends of noisy parts protrude. */
    private static final double BACKWARDS = 0.2;

    /** Greatest difference, in metres, of the distances of an edge's ends from another edge that counts as parallel. */
    private static final double PARALLEL = 1e-9;

    private ReflectedAperture aperture;
    /** For each edge: start (x, y), outward unit normal (x, y), distance from the origin, length. */
    private double[] edges = new double[6 * 256];

    /**
     * Edges on which a centre may lie. Edges behind an outline are excluded; the edges of its next part replace them.
     */
    private boolean[] open = new boolean[256];

    private int edgeCount;
    /** The first edge of each polygon, and one past the last. */
    private int[] first = new int[64];
    /** The least x, y and greatest x, y of each polygon. */
    private double[] bounds = new double[4 * 64];

    private int count;

    void begin(ReflectedAperture turned) {
        aperture = turned;
        edgeCount = 0;
        count = 0;
        first[0] = 0;
    }

    int polygons() {
        return count;
    }

    int firstEdge(int polygon) {
        return first[polygon];
    }

    int edges() {
        return edgeCount;
    }

    double startX(int edge) {
        return edges[6 * edge];
    }

    double startY(int edge) {
        return edges[6 * edge + 1];
    }

    double alongX(int edge) {
        return -edges[6 * edge + 3];
    }

    double alongY(int edge) {
        return edges[6 * edge + 2];
    }

    double length(int edge) {
        return edges[6 * edge + 5];
    }

    /** Returns true if a centre may lie on an edge. */
    boolean isOpen(int edge) {
        return open[edge];
    }

    /** Adds a part of the outline with the region on its left; apertures may touch it only from the left. */
    void addOutline(ConvexPolygon segment) {
        int from = edgeCount;
        add(segment);
        for (int edge = from; edge < edgeCount; edge++) {
            double outwards = alongY(edge) * segment.normalX(0) - alongX(edge) * segment.normalY(0);
            open[edge] = outwards <= BACKWARDS;
        }
    }

    /**
     * Adds an obstacle that may be touched from all sides. The sum traverses the edges of both polygons by growing
     * angle (de Berg et al. 2008, "Computational Geometry", section 13.3).
     */
    void add(ConvexPolygon obstacle) {
        reserve(obstacle.corners() + aperture.corners());
        int lowest = obstacle.lowest();
        int i = 0;
        int j = 0;
        double startX = obstacle.x(lowest) + aperture.x(0);
        double startY = obstacle.y(lowest) + aperture.y(0);
        double x = startX;
        double y = startY;
        while (i < obstacle.corners() || j < aperture.corners()) {
            int from = (lowest + i) % obstacle.corners();
            int to = (lowest + i + 1) % obstacle.corners();
            double obstacleX = obstacle.x(to) - obstacle.x(from);
            double obstacleY = obstacle.y(to) - obstacle.y(from);
            double apertureX = aperture.x(j + 1) - aperture.x(j);
            double apertureY = aperture.y(j + 1) - aperture.y(j);
            boolean ofDynamicObject = i < obstacle.corners()
                    && (j == aperture.corners() || ConvexPolygon.isBefore(obstacleX, obstacleY, apertureX, apertureY));
            double dx = ofDynamicObject ? obstacleX : apertureX;
            double dy = ofDynamicObject ? obstacleY : apertureY;
            i += ofDynamicObject ? 1 : 0;
            j += ofDynamicObject ? 0 : 1;
            edge(x, y, dx, dy);
            x += dx;
            y += dy;
        }
        close();
    }

    private void reserve(int more) {
        if (6 * (edgeCount + more) > edges.length) {
            int capacity = Math.max(2 * open.length, edgeCount + more);
            edges = Arrays.copyOf(edges, 6 * capacity);
            open = Arrays.copyOf(open, capacity);
        }
        if (count + 2 > first.length) {
            first = Arrays.copyOf(first, 2 * first.length);
            bounds = Arrays.copyOf(bounds, 2 * bounds.length);
        }
    }

    private void edge(double x, double y, double dx, double dy) {
        double length = Math.sqrt(dx * dx + dy * dy);
        if (length < LEAST_EDGE) {
            return;
        }
        open[edgeCount] = true;
        int at = 6 * edgeCount++;
        edges[at] = x;
        edges[at + 1] = y;
        edges[at + 2] = dy / length;
        edges[at + 3] = -dx / length;
        edges[at + 4] = (dy * x - dx * y) / length;
        edges[at + 5] = length;
    }

    private void close() {
        double minX = Double.POSITIVE_INFINITY;
        double minY = Double.POSITIVE_INFINITY;
        double maxX = Double.NEGATIVE_INFINITY;
        double maxY = Double.NEGATIVE_INFINITY;
        for (int edge = first[count]; edge < edgeCount; edge++) {
            minX = Math.min(minX, startX(edge));
            minY = Math.min(minY, startY(edge));
            maxX = Math.max(maxX, startX(edge));
            maxY = Math.max(maxY, startY(edge));
        }
        bounds[4 * count] = minX;
        bounds[4 * count + 1] = minY;
        bounds[4 * count + 2] = maxX;
        bounds[4 * count + 3] = maxY;
        first[++count] = edgeCount;
    }

    /** Returns true if an aperture with this centre overlaps no obstacle. */
    boolean allow(double x, double y) {
        for (int polygon = 0; polygon < count; polygon++) {
            if (holds(polygon, x, y)) {
                return false;
            }
        }
        return true;
    }

    private boolean holds(int polygon, double x, double y) {
        for (int edge = first[polygon]; edge < first[polygon + 1]; edge++) {
            int at = 6 * edge;
            if (edges[at + 2] * x + edges[at + 3] * y - edges[at + 4] >= -Tolerance.OVERLAP) {
                return false;
            }
        }
        return true;
    }

    /** Returns the distance in metres from a point to an edge. */
    double distance(int edge, double x, double y) {
        double along = foot(edge, x, y);
        double dx = startX(edge) + along * alongX(edge) - x;
        double dy = startY(edge) + along * alongY(edge) - y;
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** Returns the position along an edge of the point nearest to a point. */
    double foot(int edge, double x, double y) {
        double along = (x - startX(edge)) * alongX(edge) + (y - startY(edge)) * alongY(edge);
        return Math.max(0, Math.min(length(edge), along));
    }

    /**
     * Writes the interval of an edge's line inside a polygon to {@code span}: its ends where the overlap reaches the
     * tolerance, then those where it begins. Returns false if no part of the edge is inside.
     */
    boolean covers(int polygon, int edge, double[] span) {
        if (isApart(polygon, edge)) {
            return false;
        }
        double x = startX(edge);
        double y = startY(edge);
        double dx = alongX(edge);
        double dy = alongY(edge);
        double length = length(edge);
        span[0] = Double.NEGATIVE_INFINITY;
        span[1] = Double.POSITIVE_INFINITY;
        for (int i = 6 * first[polygon]; i < 6 * first[polygon + 1]; i += 6) {
            double rate = edges[i + 2] * dx + edges[i + 3] * dy;
            double inside = edges[i + 4] - edges[i + 2] * x - edges[i + 3] * y;
            double at = (inside - Tolerance.OVERLAP) / rate;
            if (Math.abs(rate) * length < PARALLEL) {
                if (inside <= Tolerance.OVERLAP) {
                    return false;
                }
            } else if (rate > 0 && at < span[1]) {
                span[1] = at;
                span[3] = inside / rate;
            } else if (rate < 0 && at > span[0]) {
                span[0] = at;
                span[2] = inside / rate;
            }
            if (span[0] >= span[1] || span[1] <= 0 || span[0] >= length) {
                return false;
            }
        }
        return true;
    }

    private boolean isApart(int polygon, int edge) {
        double x = startX(edge);
        double y = startY(edge);
        double endX = x + length(edge) * alongX(edge);
        double endY = y + length(edge) * alongY(edge);
        int at = 4 * polygon;
        return Math.max(x, endX) < bounds[at]
                || Math.max(y, endY) < bounds[at + 1]
                || Math.min(x, endX) > bounds[at + 2]
                || Math.min(y, endY) > bounds[at + 3];
    }
}
