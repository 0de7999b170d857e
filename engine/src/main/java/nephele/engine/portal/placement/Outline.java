package nephele.engine.portal.placement;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.math.bvh.ItemList;

/**
 * Finds the boundary of a union of convex polygons that may abut, overlap, meet in T-junctions, and have cracks of
 * noise between them. A part of an edge is inside the union if a point slightly outwards is in another polygon or in a
 * crack beside one; the other parts bound the union. Without noise, the error is at most 10⁻⁷ m.
 */
final class Outline {
    /** Wider than a crack, for an edge that two overlapping polygons share on the same side. */
    private static final double BEYOND_CRACK = 1e-7;

    private static final double LEAST_PART = 1e-9;

    /** Apparent extent of a corner: slightly more than a crack's width. */
    private static final double CORNER = 1.2 * Tolerance.CRACK;

    /** Longest tip of a hole of 6° or more, measured where it is as narrow as a crack. */
    private static final double LONGEST_TIP = 20 * Tolerance.CRACK;

    /** Least gap in the middle of a tip; a crack that noise closes has less. */
    private static final double NARROW = Tolerance.CRACK / 10;

    /** Greatest deviation in metres of a tip's gap from even narrowing; noise in its middle deviates by more. */
    private static final double EVEN = Tolerance.CRACK / 5;

    /** Positions between the place where a tip is two cracks wide and its end. */
    private static final double[] TIP_SHARES = {-0.25, 0.5, 0.75};

    private final PolygonIndex polygons;
    private final ItemList near = new ItemList();
    private final List<ConvexPolygon> parts = new ArrayList<>();

    private Outline(PolygonIndex polygons) {
        this.polygons = polygons;
    }

    /** Returns the boundary as segments, in no order. */
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

    /** The intervals of an edge near other polygons. */
    private static final class Neighbours {
        private final LineCoverage edge;
        private final LineCoverage far;
        private final LineCoverage close;
        private final LineCoverage between;
        /** In a polygon or in a crack beside one. */
        private final List<double[]> covered = new ArrayList<>();
        /** Certainly in a polygon. */
        private final List<double[]> touched = new ArrayList<>();
        /** At most a wide crack of noise away from a polygon. */
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
         * Extends a part that ends at {@code at} to the place where the edge is certainly in another polygon, if that
         * is near and the gap narrows on the way: beside a corner that points into the union, and in the tip of a hole,
         * an edge seems to be in a crack.
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
         * Returns true if the gap narrows evenly from before {@code at}, where it is two cracks wide, to none at {@code
         * end}. A crack that ends at a hole has no gap before it.
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

        /** Returns the distance in metres from a point of the edge straight outwards to the next polygon. */
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
