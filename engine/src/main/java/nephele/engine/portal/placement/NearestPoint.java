package nephele.engine.portal.placement;

import java.util.Arrays;
import nephele.engine.math.bvh.ItemList;

/**
 * Finds the point nearest to an aim that is in a region and in none of the forbidden polygons. It is the aim itself, or
 * a point on an edge of one of the polygons: the projection of the aim, or the end of an interval that no other polygon
 * covers.
 */
final class NearestPoint {
    /** Difference of distances below which two places are equally near; the one with the lower x, then y, is chosen. */
    private static final double EQUALLY_NEAR = 1e-9;

    private static final int SPAN = 4;

    private final ForbiddenCentres forbidden;
    private final ItemList found = new ItemList();
    private final double[] span = new double[SPAN];
    private long[] order = new long[256];
    /** Intervals as written by {@link ForbiddenCentres#covers}. */
    private double[] spans = new double[32 * SPAN];
    /** The polygon that last covered a whole edge; it often covers the next one too. */
    private int lastAll;

    private Region region;
    private double aimX;
    private double aimY;
    private double x;
    private double y;
    private double distance;

    NearestPoint(ForbiddenCentres forbidden) {
        this.forbidden = forbidden;
    }

    double x() {
        return x;
    }

    double y() {
        return y;
    }

    /** Returns the distance in metres from the aim. */
    double distance() {
        return distance;
    }

    /**
     * Searches a point.
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
        if (forbidden.allow(aimX, aimY) && region.covers(aimX, aimY, found)) {
            take(aimX, aimY, 0);
            return true;
        }
        int count = sortedEdges();
        for (int i = 0; i < count; i++) {
            if (Float.intBitsToFloat((int) (order[i] >>> 32)) > distance + EQUALLY_NEAR) {
                break;
            }
            consider((int) order[i]);
        }
        return !Double.isNaN(x);
    }

    /** Sorts the edges in reach by distance: the key is a lower bound of the distance above the edge's number. */
    private int sortedEdges() {
        int count = 0;
        for (int edge = 0; edge < forbidden.edges(); edge++) {
            double away = forbidden.isOpen(edge) ? forbidden.distance(edge, aimX, aimY) : Double.POSITIVE_INFINITY;
            if (away <= distance) {
                if (count == order.length) {
                    order = Arrays.copyOf(order, 2 * count);
                }
                float bound = Math.max(0, Math.nextDown((float) away));
                order[count++] = (long) Float.floatToIntBits(bound) << 32 | edge;
            }
        }
        Arrays.sort(order, 0, count);
        return count;
    }

    private void consider(int edge) {
        int count = coveredSpans(edge);
        double foot = forbidden.foot(edge, aimX, aimY);
        double from = 0;
        double legalFrom = 0;
        for (int i = 0; i < SPAN * count; i += SPAN) {
            if (spans[i] >= from) {
                offer(edge, legal(foot, legalFrom, spans[i + 2], (from + spans[i]) / 2));
            }
            if (spans[i + 1] > from) {
                from = spans[i + 1];
                legalFrom = spans[i + 3];
            }
        }
        double length = forbidden.length(edge);
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
        int count = 0;
        for (int polygon = 0; polygon < forbidden.polygons(); polygon++) {
            if (coversAll(polygon, edge)) {
                lastAll = polygon;
                return 1;
            } else if (span[0] < span[1]) {
                insert(count++);
            }
        }
        return count;
    }

    /** Returns true if a polygon other than the edge's own forbids all of it; leaves its interval in {@code span}. */
    private boolean coversAll(int polygon, int edge) {
        boolean own = forbidden.firstEdge(polygon) <= edge && edge < forbidden.firstEdge(polygon + 1);
        if (own || !forbidden.covers(polygon, edge, span)) {
            span[0] = Double.POSITIVE_INFINITY;
            return false;
        }
        if (span[0] < 0 && span[1] > forbidden.length(edge)) {
            System.arraycopy(span, 0, spans, 0, SPAN);
            return true;
        }
        return false;
    }

    private void insert(int count) {
        int at = SPAN * count;
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
        double px = forbidden.startX(edge) + along * forbidden.alongX(edge);
        double py = forbidden.startY(edge) + along * forbidden.alongY(edge);
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
