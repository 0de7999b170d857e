package nephele.engine.portal.placement;

import java.util.Arrays;
import nephele.engine.math.bvh.ItemList;

/**
 * Finds the centre nearest to an aim at which an aperture is in a region and overlaps no obstacle. For each convex
 * obstacle the forbidden centres are its Minkowski sum with the reflected aperture, a convex polygon. The nearest centre
 * is the aim itself, or a point on an edge of one of these polygons: the projection of the aim, or the end of an interval
 * that no other polygon covers. Filled again for every query.
 */
final class CentreSearch {
    private static final double LEAST_EDGE = 1e-12;

    /** Sine of the angle to an outline from which its next part applies; the ends of noisy parts protrude. */
    private static final double BACKWARDS = 0.2;

    /** Greatest difference, in metres, of the distances of an edge's ends from another edge that counts as parallel. */
    private static final double PARALLEL = 1e-9;

    private static final int SPAN = 4;

    /** Difference of distances below which two places are equally near; the one with the lower x, then y, is chosen. */
    private static final double EQUALLY_NEAR = 1e-9;

    private ConvexPolygon aperture;
    private int apertureLowest;
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

    private final ItemList found = new ItemList();
    private final double[] span = new double[SPAN];
    private long[] order = new long[256];
    /** Intervals as written by {@link #covers}. */
    private double[] spans = new double[32 * SPAN];
    /** The polygon that last covered a whole edge; it often covers the next one too. */
    private int lastAll;

    private Region region;
    private double aimX;
    private double aimY;
    private double x;
    private double y;
    private double distance;

    /** @param reflected as {@link ConvexPolygon#reflected} returns it */
    void begin(ConvexPolygon reflected) {
        aperture = reflected;
        apertureLowest = reflected.lowest();
        edgeCount = 0;
        count = 0;
        first[0] = 0;
    }

    int polygons() {
        return count;
    }

    private double startX(int edge) {
        return edges[6 * edge];
    }

    private double startY(int edge) {
        return edges[6 * edge + 1];
    }

    private double alongX(int edge) {
        return -edges[6 * edge + 3];
    }

    private double alongY(int edge) {
        return edges[6 * edge + 2];
    }

    private double length(int edge) {
        return edges[6 * edge + 5];
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
        double startX = obstacle.x(lowest) + aperture.x(apertureLowest);
        double startY = obstacle.y(lowest) + aperture.y(apertureLowest);
        double x = startX;
        double y = startY;
        while (i < obstacle.corners() || j < aperture.corners()) {
            int from = (lowest + i) % obstacle.corners();
            int to = (lowest + i + 1) % obstacle.corners();
            double obstacleX = obstacle.x(to) - obstacle.x(from);
            double obstacleY = obstacle.y(to) - obstacle.y(from);
            int start = (apertureLowest + j) % aperture.corners();
            int end = (apertureLowest + j + 1) % aperture.corners();
            double apertureX = aperture.x(end) - aperture.x(start);
            double apertureY = aperture.y(end) - aperture.y(start);
            boolean isOfObstacle = i < obstacle.corners()
                    && (j == aperture.corners() || ConvexPolygon.isBefore(obstacleX, obstacleY, apertureX, apertureY));
            double dx = isOfObstacle ? obstacleX : apertureX;
            double dy = isOfObstacle ? obstacleY : apertureY;
            i += isOfObstacle ? 1 : 0;
            j += isOfObstacle ? 0 : 1;
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
    private boolean isAllowed(double x, double y) {
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
    private double distance(int edge, double x, double y) {
        double along = foot(edge, x, y);
        double dx = startX(edge) + along * alongX(edge) - x;
        double dy = startY(edge) + along * alongY(edge) - y;
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** Returns the position along an edge of the point nearest to a point. */
    private double foot(int edge, double x, double y) {
        double along = (x - startX(edge)) * alongX(edge) + (y - startY(edge)) * alongY(edge);
        return Math.max(0, Math.min(length(edge), along));
    }

    /**
     * Writes the interval of an edge's line inside a polygon to {@code span}: its ends where the overlap reaches the
     * tolerance, then those where it begins. Returns false if no part of the edge is inside.
     */
    private boolean covers(int polygon, int edge, double[] span) {
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

    /** Returns the x of the centre found. */
    double x() {
        return x;
    }

    double y() {
        return y;
    }

    /** Returns the distance in metres of the centre found from the aim. */
    double distance() {
        return distance;
    }

    /**
     * Searches the centre nearest to an aim.
     *
     * @return true if there is one within {@code limit}
     */
    boolean find(Region within, double atX, double atY, double limit) {
        region = within;
        aimX = atX;
        aimY = atY;
        x = Double.NaN;
        y = Double.NaN;
        distance = limit;
        lastAll = 0;
        if (isAllowed(aimX, aimY) && region.covers(aimX, aimY, found)) {
            take(aimX, aimY, 0);
            return true;
        }
        int edgesInReach = sortedEdges();
        for (int i = 0; i < edgesInReach; i++) {
            if (Float.intBitsToFloat((int) (order[i] >>> 32)) > distance + EQUALLY_NEAR) {
                break;
            }
            consider((int) order[i]);
        }
        return !Double.isNaN(x);
    }

    /** Sorts the edges in reach by distance: the key is a lower bound of the distance above the edge's number. */
    private int sortedEdges() {
        int size = 0;
        for (int edge = 0; edge < edgeCount; edge++) {
            double away = open[edge] ? distance(edge, aimX, aimY) : Double.POSITIVE_INFINITY;
            if (away <= distance) {
                if (size == order.length) {
                    order = Arrays.copyOf(order, 2 * size);
                }
                float bound = Math.max(0, Math.nextDown((float) away));
                order[size++] = (long) Float.floatToIntBits(bound) << 32 | edge;
            }
        }
        Arrays.sort(order, 0, size);
        return size;
    }

    private void consider(int edge) {
        int covered = coveredSpans(edge);
        double foot = foot(edge, aimX, aimY);
        double from = 0;
        double legalFrom = 0;
        for (int i = 0; i < SPAN * covered; i += SPAN) {
            if (spans[i] >= from) {
                offer(edge, legal(foot, legalFrom, spans[i + 2], (from + spans[i]) / 2));
            }
            if (spans[i + 1] > from) {
                from = spans[i + 1];
                legalFrom = spans[i + 3];
            }
        }
        double length = length(edge);
        if (from <= length) {
            offer(edge, legal(foot, legalFrom, length, (from + length) / 2));
        }
    }

    /**
     * Returns the place nearest to {@code foot} in an interval without overlap; the middle if only the tolerance makes
     * it non-empty.
     */
    private static double legal(double foot, double from, double to, double middle) {
        return from <= to ? Math.max(from, Math.min(to, foot)) : middle;
    }

    /**
     * Collects the intervals of an edge that other polygons forbid, sorted by start; a single one if it is the whole
     * edge.
     */
    private int coveredSpans(int edge) {
        if (coversAll(lastAll, edge)) {
            return 1;
        }
        int covered = 0;
        for (int polygon = 0; polygon < count; polygon++) {
            if (coversAll(polygon, edge)) {
                lastAll = polygon;
                return 1;
            } else if (span[0] < span[1]) {
                insert(covered++);
            }
        }
        return covered;
    }

    /** Returns true if a polygon other than the edge's own forbids all of it; leaves its interval in {@code span}. */
    private boolean coversAll(int polygon, int edge) {
        boolean own = first[polygon] <= edge && edge < first[polygon + 1];
        if (own || !covers(polygon, edge, span)) {
            span[0] = Double.POSITIVE_INFINITY;
            return false;
        }
        if (span[0] < 0 && span[1] > length(edge)) {
            System.arraycopy(span, 0, spans, 0, SPAN);
            return true;
        }
        return false;
    }

    private void insert(int place) {
        int at = SPAN * place;
        if (at + SPAN > spans.length) {
            spans = Arrays.copyOf(spans, 2 * spans.length);
        }
        while (at > 0 && spans[at - SPAN] > span[0]) {
            System.arraycopy(spans, at - SPAN, spans, at, SPAN);
            at -= SPAN;
        }
        System.arraycopy(span, 0, spans, at, SPAN);
    }

    private void offer(int edge, double along) {
        double px = startX(edge) + along * alongX(edge);
        double py = startY(edge) + along * alongY(edge);
        double dx = px - aimX;
        double dy = py - aimY;
        double away = Math.sqrt(dx * dx + dy * dy);
        boolean nearer = away < distance - EQUALLY_NEAR;
        boolean before = px < x || px == x && py < y || Double.isNaN(x);
        if ((nearer || away <= distance + EQUALLY_NEAR && before) && region.covers(px, py, found)) {
            take(px, py, away);
        }
    }

    private void take(double px, double py, double away) {
        x = px;
        y = py;
        distance = away;
    }
}
