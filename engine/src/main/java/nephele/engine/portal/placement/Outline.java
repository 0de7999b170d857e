package nephele.engine.portal.placement;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.ItemList;

/**
 * The edges of a union of convex polygons that may abut, overlap, meet in T-junctions, and leave cracks of noise between
 * them. A part of an edge is inside the union when a point a little way out of it lies in another polygon or in a crack
 * beside one; what is left bounds the union. Where nothing is noisy, nothing is off by more than 10⁻⁷ m.
 */
final class Outline {
    /** More than a crack: beyond an edge that two overlapping polygons share on the same side lies nothing. */
    private static final double BEYOND_CRACK = 1e-7;

    private static final double LEAST_PART = 1e-9;

    /** A little more than a crack's width, which is how far a corner seems to reach. */
    private static final double CORNER = 1.2 * Tolerance.CRACK;

    /** The tip of a hole of 6° or more is shorter where it is as narrow as a crack. */
    private static final double LONGEST_TIP = 20 * Tolerance.CRACK;

    /** In the middle of a tip the gap is wider than this; where noise happens to close a crack it is less. */
    private static final double NARROW = Tolerance.CRACK / 10;

    private final ShapeSet polygons;
    private final ItemList near = new ItemList();
    private final List<ConvexPolygon> parts = new ArrayList<>();

    private Outline(ShapeSet polygons) {
        this.polygons = polygons;
    }

    /** Segments, in no special order. */
    static List<ConvexPolygon> of(ShapeSet polygons) {
        Outline outline = new Outline(polygons);
        for (int polygon = 0; polygon < polygons.size(); polygon++) {
            for (int edge = 0; edge < polygons.shape(polygon).corners(); edge++) {
                outline.add(polygon, edge);
            }
        }
        return outline.parts;
    }

    private void add(int polygon, int edge) {
        ConvexPolygon p = polygons.shape(polygon);
        Line line = Line.beyond(p, edge, Tolerance.CRACK + BEYOND_CRACK);
        near.clear();
        polygons.overlapping(line.bounds().grown(2 * Tolerance.CRACK), near);
        Neighbours others = new Neighbours(p, edge);
        for (int i = 0; i < near.size(); i++) {
            if (near.get(i) != polygon) {
                others.add(polygons.shape(near.get(i)));
            }
        }
        others.covered.sort((a, b) -> Arrays.compare(a, b));
        double from = 0;
        for (double[] span : others.covered) {
            part(others, from, Math.min(span[0], line.length()));
            from = Math.max(from, span[1]);
        }
        part(others, from, line.length());
    }

    private void part(Neighbours others, double from, double to) {
        if (to - from > LEAST_PART) {
            boolean stub = to - from <= 2 * Tolerance.CRACK;
            double low = stub ? from : others.tip(from, -1);
            double high = stub ? to : others.tip(to, 1);
            Line edge = others.edge;
            parts.add(ConvexPolygon.of(new double[] {edge.atX(low), edge.atY(low), edge.atX(high), edge.atY(high)}));
        }
    }

    /** Where along an edge the other polygons are. */
    private static final class Neighbours {
        private final Line edge;
        private final Line far;
        private final Line close;
        private final Line between;
        /** In a polygon or in a crack beside one. */
        private final List<double[]> covered = new ArrayList<>();
        /** In a polygon without doubt. */
        private final List<double[]> touched = new ArrayList<>();
        /** Not farther from a polygon than a wide crack of noise is. */
        private final List<double[]> noisy = new ArrayList<>();

        Neighbours(ConvexPolygon polygon, int number) {
            edge = Line.beyond(polygon, number, 0);
            far = Line.beyond(polygon, number, Tolerance.CRACK + BEYOND_CRACK);
            close = Line.beyond(polygon, number, BEYOND_CRACK);
            between = Line.beyond(polygon, number, NARROW);
        }

        void add(ConvexPolygon other) {
            keep(far.near(other, Tolerance.CRACK), covered);
            keep(close.within(other), touched);
            keep(between.within(other), noisy);
        }

        private static void keep(double[] span, List<double[]> spans) {
            if (span != null) {
                spans.add(span);
            }
        }

        /**
         * Beside a corner that points into the union, and in the tip of a hole, an edge seems to lie in a crack. So a part
         * that ends at {@code at} reaches on to where the edge is in another polygon without doubt, if that is near and
         * the way there leads along a gap that narrows.
         *
         * @param sense 1 for the part's far end, −1 for its near end
         */
        double tip(double at, int sense) {
            double end = sense > 0 ? edge.length() : 0;
            for (double[] span : touched) {
                double side = sense > 0 ? span[0] : span[1];
                boolean beyond = sense > 0 ? span[1] > at : span[0] < at;
                if (beyond && sense * side < sense * end) {
                    end = sense * Math.max(sense * side, sense * at);
                }
            }
            double doubtful = Math.abs(end - at);
            if (doubtful <= CORNER || doubtful <= LONGEST_TIP && !isNoisy((at + end) / 2)) {
                return end;
            }
            return at + sense * Tolerance.CRACK / 2;
        }

        private boolean isNoisy(double at) {
            return noisy.stream().anyMatch(span -> span[0] <= at && at <= span[1]);
        }
    }

    /** A stretch of a straight line. */
    private record Line(double x, double y, double dx, double dy, double length) {
        static Line beyond(ConvexPolygon polygon, int edge, double metres) {
            double nx = polygon.normalX(edge);
            double ny = polygon.normalY(edge);
            return new Line(
                    polygon.x(edge) + metres * nx, polygon.y(edge) + metres * ny, -ny, nx, polygon.length(edge));
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

        /** The stretch inside a polygon; {@code null} for none. */
        double[] within(ConvexPolygon polygon) {
            return polygon.corners() < 3 ? null : inside(polygon);
        }

        /** The stretch that is not farther than {@code metres} from a polygon; {@code null} for none. */
        double[] near(ConvexPolygon polygon, double metres) {
            double[] span = inside(polygon);
            for (int edge = 0; edge < polygon.corners(); edge++) {
                span = union(span, besideEdge(polygon, edge, metres));
                span = union(span, aroundCorner(polygon.x(edge), polygon.y(edge), metres));
            }
            return span == null || span[1] <= 0 || span[0] >= length ? null : span;
        }

        /** The parts of a convex shape make one stretch. */
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

        /** Keeps what has nx · x + ny · y ≤ d. */
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
}
