package nephele.engine.portal.placement;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import nephele.engine.math.bvh.ItemList;

/**
 * Finds the boundary of a union of convex polygons that may abut, overlap, meet in T-junctions, and have cracks of
 * noise between them. A part of an edge is inside the union if a point slightly outwards is in another polygon or in a
 * crack beside one; the other parts bound the union. Without noise, the error is at most 10⁻⁷ m.
 *
 * <p>Parts that follow each other along one line, except for noise, are merged into one straight segment. A wall's edge
 * that was cut into pieces becomes one edge again: otherwise noise of 10 µm on a piece of 1 cm would turn the direction
 * in which a portal slides by a thousandth, and move it by that fraction of the slide. A segment is at the position of
 * its innermost parts. The longest part is the seed. Because noise in its ends tilts it, the search for others permits an
 * offset that grows with the distance along the line, and keeps those that are on the line fitted through all of them.
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
    private static final double[] TIP_FRACTIONS = {-0.25, 0.5, 0.75};

    /** Greatest distance in metres from the common line that counts as noise. */
    private static final double NOISE = Tolerance.CRACK / 2;

    /** Least cosine between the line and a part of it. */
    private static final double ALONG = 0.9;

    private static final int MOST_FITS = 10;

    private final PolygonIndex polygons;
    private final ItemList near = new ItemList();
    private final List<ConvexPolygon> parts = new ArrayList<>();

    /** The parts again, in an index. */
    private final PolygonIndex segments;

    /** The parts that belong to a straight segment, and those of the present one. */
    private final boolean[] taken;

    private List<Integer> members = List.of();

    private Outline(PolygonIndex polygons) {
        this.polygons = polygons;
        for (int polygon = 0; polygon < polygons.size(); polygon++) {
            for (int edge = 0; edge < polygons.shape(polygon).corners(); edge++) {
                add(polygon, edge);
            }
        }
        segments = new PolygonIndex(parts);
        taken = new boolean[parts.size()];
    }

    /** Returns the boundary as straight segments with the union on their left, the longest seed's first. */
    static List<ConvexPolygon> of(PolygonIndex polygons) {
        Outline outline = new Outline(polygons);
        List<ConvexPolygon> parts = outline.parts;
        Integer[] order = new Integer[parts.size()];
        Arrays.setAll(order, i -> i);
        Arrays.sort(order, Comparator.comparingDouble(i -> -parts.get(i).length(0)));
        List<ConvexPolygon> straight = new ArrayList<>();
        for (int seed : order) {
            if (!outline.taken[seed]) {
                straight.add(outline.from(seed));
            }
        }
        return straight;
    }

    private void add(int polygon, int edge) {
        ConvexPolygon p = polygons.shape(polygon);
        PlaneLine line = PlaneLine.beyond(p, edge, Tolerance.CRACK + BEYOND_CRACK);
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
            PlaneLine edge = others.edge;
            parts.add(ConvexPolygon.of(new double[] {edge.atX(low), edge.atY(low), edge.atX(high), edge.atY(high)}));
        }
    }

    private ConvexPolygon from(int seed) {
        ConvexPolygon shape = segments.shape(seed);
        PlaneLine line = fit(seed, NOISE / shape.length(0));
        if (!isOn(line, shape, 0)) {
            line = fit(seed, 0);
        }
        members.forEach(member -> taken[member] = true);
        return members.size() == 1 ? shape : innermost(line);
    }

    /**
     * Returns the line through the parts that continue a seed, which become the members.
     *
     * @param doubt initial uncertainty of the slope of the seed's line, see {@link #isOn}
     */
    private PlaneLine fit(int seed, double doubt) {
        members = List.of(seed);
        PlaneLine line = PlaneLine.beyond(segments.shape(seed), 0, 0);
        for (int i = 0; i < MOST_FITS; i++) {
            List<Integer> grown = reached(seed, line, i == 0 ? doubt : 0);
            boolean same = grown.equals(members);
            members = grown;
            if (same) {
                break;
            }
            line = fitted(line);
        }
        return line;
    }

    /** Returns the parts on the line, connected one to the next, in ascending order. */
    private List<Integer> reached(int seed, PlaneLine line, double doubt) {
        List<Integer> found = new ArrayList<>(List.of(seed));
        double[] span = line.span(segments.shape(seed));
        boolean grows = true;
        while (grows) {
            grows = false;
            near.clear();
            segments.overlapping(line.bounds(span[0], span[1]).grown(2 * Tolerance.CRACK), near);
            for (int i = 0; i < near.size(); i++) {
                int part = near.get(i);
                if (!taken[part] && !found.contains(part) && isOn(line, segments.shape(part), doubt)) {
                    found.add(part);
                    span = PlaneLine.union(span, line.span(segments.shape(part)));
                    grows = true;
                }
            }
        }
        found.sort(null);
        return found;
    }

    /** Fits a line by least squares to the parts' points, in the frame of the previous line. */
    private PlaneLine fitted(PlaneLine line) {
        double weight = 0;
        double middleAlong = 0;
        double middleOff = 0;
        for (int member : members) {
            ConvexPolygon part = segments.shape(member);
            double length = part.length(0);
            weight += length;
            middleAlong += length * (line.along(part, 0) + line.along(part, 1)) / 2;
            middleOff += length * (line.off(part, 0) + line.off(part, 1)) / 2;
        }
        middleAlong /= weight;
        middleOff /= weight;
        double square = 0;
        double product = 0;
        for (int member : members) {
            ConvexPolygon part = segments.shape(member);
            for (int end = 0; end < 2; end++) {
                double along = line.along(part, end) - middleAlong;
                square += part.length(0) * along * along;
                product += part.length(0) * along * (line.off(part, end) - middleOff);
            }
        }
        return line.moved(middleAlong, middleOff, product / square);
    }

    private ConvexPolygon innermost(PlaneLine line) {
        double inwards = Double.NEGATIVE_INFINITY;
        double[] span = line.span(segments.shape(members.get(0)));
        for (int member : members) {
            ConvexPolygon part = segments.shape(member);
            inwards = Math.max(inwards, Math.max(line.off(part, 0), line.off(part, 1)));
            span = PlaneLine.union(span, line.span(part));
        }
        return ConvexPolygon.of(new double[] {
            line.atX(span[0], inwards),
            line.atY(span[0], inwards),
            line.atX(span[1], inwards),
            line.atY(span[1], inwards)
        });
    }

    /**
     * Returns true if a segment is on a line except for noise.
     *
     * @param doubt uncertainty of the line's slope in metres per metre: the permitted offset grows with the distance
     */
    private static boolean isOn(PlaneLine line, ConvexPolygon segment, double doubt) {
        return isNear(line, segment, 0, doubt) && isNear(line, segment, 1, doubt) && line.cosine(segment) >= ALONG;
    }

    private static boolean isNear(PlaneLine line, ConvexPolygon segment, int end, double doubt) {
        return Math.abs(line.off(segment, end)) <= NOISE + doubt * Math.abs(line.along(segment, end));
    }

    /** The intervals of an edge near other polygons. */
    private static final class Neighbours {
        private final PlaneLine edge;
        private final PlaneLine far;
        private final PlaneLine close;
        private final PlaneLine between;
        /** In a polygon or in a crack beside one. */
        private final List<double[]> covered = new ArrayList<>();
        /** Certainly in a polygon. */
        private final List<double[]> touched = new ArrayList<>();
        /** At most a wide crack of noise away from a polygon. */
        private final List<double[]> noisy = new ArrayList<>();

        private final List<ConvexPolygon> others = new ArrayList<>();

        Neighbours(ConvexPolygon polygon, int number) {
            edge = PlaneLine.beyond(polygon, number, 0);
            far = PlaneLine.beyond(polygon, number, Tolerance.CRACK + BEYOND_CRACK);
            close = PlaneLine.beyond(polygon, number, BEYOND_CRACK);
            between = PlaneLine.beyond(polygon, number, NARROW);
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
            for (double fraction : TIP_FRACTIONS) {
                double even = 2 * Tolerance.CRACK * (1 - fraction);
                if (!(Math.abs(gap(at + fraction * (end - at)) - even) < EVEN)) {
                    return false;
                }
            }
            return true;
        }

        /** Returns the distance in metres from a point of the edge straight outwards to the next polygon. */
        private double gap(double at) {
            PlaneLine out = edge.outFrom(at, 3 * Tolerance.CRACK);
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
