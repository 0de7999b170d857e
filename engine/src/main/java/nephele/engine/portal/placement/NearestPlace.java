package nephele.engine.portal.placement;

import java.util.Arrays;
import nephele.engine.math.ItemList;

/**
 * The point nearest to an aim that lies in a region and in none of the forbidden polygons. It is the aim itself, or on
 * an edge of one of the polygons: there the foot of the aim, or the end of a stretch that no other polygon covers.
 */
final class NearestPlace {
    /** Of two places as near as that the one with the lower x, then y, is taken. */
    private static final double EQUALLY_NEAR = 1e-9;

    private final ForbiddenCentres forbidden;
    private final ItemList found = new ItemList();
    private final double[] span = new double[2];
    private long[] order = new long[256];
    private double[] spans = new double[64];
    private Region region;
    private double aimX;
    private double aimY;
    private double x;
    private double y;
    private double distance;

    NearestPlace(ForbiddenCentres forbidden) {
        this.forbidden = forbidden;
    }

    double x() {
        return x;
    }

    double y() {
        return y;
    }

    /** Metres from the aim. */
    double distance() {
        return distance;
    }

    /** @return whether there is one not farther than {@code limit} */
    boolean find(Region within, double atX, double atY, double limit) {
        region = within;
        aimX = atX;
        aimY = atY;
        x = Double.NaN;
        y = Double.NaN;
        distance = limit;
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

    /** Edges in reach, nearest first: a lower bound of the distance above the edge's number. */
    private int sortedEdges() {
        int count = 0;
        for (int edge = 0; edge < forbidden.edges(); edge++) {
            double away = forbidden.distance(edge, aimX, aimY);
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
        for (int i = 0; i < count; i++) {
            offer(edge, foot, from, spans[2 * i]);
            from = Math.max(from, spans[2 * i + 1]);
        }
        offer(edge, foot, from, forbidden.length(edge));
    }

    /** The stretches of an edge that other polygons forbid, by where they begin. */
    private int coveredSpans(int edge) {
        int count = 0;
        for (int polygon = 0; polygon < forbidden.polygons(); polygon++) {
            boolean own = forbidden.firstEdge(polygon) <= edge && edge < forbidden.firstEdge(polygon + 1);
            if (!own && forbidden.covers(polygon, edge, span)) {
                insert(count++);
            }
        }
        return count;
    }

    private void insert(int count) {
        if (2 * count + 2 > spans.length) {
            spans = Arrays.copyOf(spans, 2 * spans.length);
        }
        int at = 2 * count;
        while (at > 0 && spans[at - 2] > span[0]) {
            spans[at] = spans[at - 2];
            spans[at + 1] = spans[at - 1];
            at -= 2;
        }
        spans[at] = span[0];
        spans[at + 1] = span[1];
    }

    /** The free stretch from {@code from} to {@code to} of an edge. */
    private void offer(int edge, double foot, double from, double to) {
        if (from > to) {
            return;
        }
        double along = Math.max(from, Math.min(to, foot));
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
