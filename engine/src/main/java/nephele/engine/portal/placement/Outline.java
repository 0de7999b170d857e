package nephele.engine.portal.placement;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.math.bvh.ItemList;

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

    /** Metres off an even narrowing that a tip's gap may be; in its middle a gap of noise is off by more. */
    private static final double EVEN = Tolerance.CRACK / 5;

    /** Of the way from where a tip is two cracks wide to its end. */
    private static final double[] TIP_SHARES = {-0.25, 0.5, 0.75};

    private final PolygonIndex polygons;
    private final ItemList near = new ItemList();
    private final List<ConvexPolygon> parts = new ArrayList<>();

    private Outline(PolygonIndex polygons) {
        this.polygons = polygons;
    }

    /** Segments, in no special order. */
    static List<ConvexPolygon> of(PolygonIndex polygons) {
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
        LineCoverage line = LineCoverage.beyond(p, edge, Tolerance.CRACK + BEYOND_CRACK);
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
            LineCoverage edge = others.edge;
            parts.add(ConvexPolygon.of(new double[] {edge.atX(low), edge.atY(low), edge.atX(high), edge.atY(high)}));
        }
    }

    /** Where along an edge the other polygons are. */
    private static final class Neighbours {
        private final LineCoverage edge;
        private final LineCoverage far;
        private final LineCoverage close;
        private final LineCoverage between;
        /** In a polygon or in a crack beside one. */
        private final List<double[]> covered = new ArrayList<>();
        /** In a polygon without doubt. */
        private final List<double[]> touched = new ArrayList<>();
        /** Not farther from a polygon than a wide crack of noise is. */
        private final List<double[]> noisy = new ArrayList<>();

        private final List<ConvexPolygon> others = new ArrayList<>();

        Neighbours(ConvexPolygon polygon, int number) {
            edge = LineCoverage.beyond(polygon, number, 0);
            far = LineCoverage.beyond(polygon, number, Tolerance.CRACK + BEYOND_CRACK);
            close = LineCoverage.beyond(polygon, number, BEYOND_CRACK);
            between = LineCoverage.beyond(polygon, number, NARROW);
        }

        void add(ConvexPolygon other) {
            others.add(other);
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
            boolean tip = doubtful <= LONGEST_TIP && !isNoisy((at + end) / 2);
            if (doubtful <= CORNER || tip || narrowsEvenly(at, end)) {
                return end;
            }
            return at + sense * Tolerance.CRACK / 2;
        }

        /**
         * Whether the gap shrinks evenly from before {@code at}, where it is two cracks wide, to none at {@code end}. A
         * crack that ends at a hole has nothing beside it before.
         */
        private boolean narrowsEvenly(double at, double end) {
            for (double share : TIP_SHARES) {
                double even = 2 * Tolerance.CRACK * (1 - share);
                if (!(Math.abs(gap(at + share * (end - at)) - even) < EVEN)) {
                    return false;
                }
            }
            return true;
        }

        /** Metres from a point of the edge straight out to the next polygon. */
        private double gap(double at) {
            LineCoverage out = edge.outFrom(at, 3 * Tolerance.CRACK);
            double least = Double.POSITIVE_INFINITY;
            for (ConvexPolygon other : others) {
                double[] span = out.within(other);
                if (span != null && span[1] > 0) {
                    least = Math.min(least, Math.max(0, span[0]));
                }
            }
            return least;
        }

        private boolean isNoisy(double at) {
            return noisy.stream().anyMatch(span -> span[0] <= at && at <= span[1]);
        }
    }
}
