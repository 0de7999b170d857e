package nephele.engine.portal.placement;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.bvh.ItemList;

/**
 * Merges outline parts that follow each other along one line, except for noise, into one straight segment. A wall's
 * edge that was cut into pieces becomes one edge again: otherwise noise of 10 µm on a piece of 1 cm would turn the
 * direction in which a portal slides by a thousandth, and move it by that share of the slide. A segment is at the
 * position of its innermost parts. The longest part is the seed. Because noise in its ends tilts it, the search for
 * others permits an offset that grows with the distance along the line, and keeps those that are on the line fitted
 * through all of them.
 */
final class OutlineSimplification {
    /** Greatest distance in metres from the common line that counts as noise. */
    private static final double NOISE = Tolerance.CRACK / 2;

    /** Least cosine between the line and a part of it. */
    private static final double ALONG = 0.9;

    private static final int MOST_FITS = 10;

    private final PolygonIndex parts;
    private final boolean[] taken;
    private final ItemList near = new ItemList();

    private OutlineSimplification(List<ConvexPolygon> parts) {
        this.parts = new PolygonIndex(parts);
        taken = new boolean[parts.size()];
    }

    /** @param parts segments with the region on their left */
    static List<ConvexPolygon> of(List<ConvexPolygon> parts) {
        OutlineSimplification simplification = new OutlineSimplification(parts);
        Integer[] order = new Integer[parts.size()];
        Arrays.setAll(order, i -> i);
        Arrays.sort(order, Comparator.comparingDouble(i -> -parts.get(i).length(0)));
        List<ConvexPolygon> straight = new ArrayList<>();
        for (int seed : order) {
            if (!simplification.taken[seed]) {
                straight.add(simplification.from(seed));
            }
        }
        return straight;
    }

    private ConvexPolygon from(int seed) {
        ConvexPolygon shape = parts.shape(seed);
        Fit fit = fit(seed, NOISE / shape.length(0));
        if (!fit.line.holds(shape, 0)) {
            fit = fit(seed, 0);
        }
        fit.members.forEach(member -> taken[member] = true);
        return fit.members.size() == 1 ? shape : innermost(fit.line, fit.members);
    }

    private record Fit(Line line, List<Integer> members) {}

    /** @param doubt initial uncertainty of the slope of the seed's line, see {@link Line#holds} */
    private Fit fit(int seed, double doubt) {
        List<Integer> members = List.of(seed);
        Line line = Line.along(parts.shape(seed));
        for (int i = 0; i < MOST_FITS; i++) {
            List<Integer> grown = reached(seed, line, i == 0 ? doubt : 0);
            boolean same = grown.equals(members);
            members = grown;
            if (same) {
                break;
            }
            line = fitted(line, members);
        }
        return new Fit(line, members);
    }

    /** Returns the parts on the line, connected one to the next, in ascending order. */
    private List<Integer> reached(int seed, Line line, double doubt) {
        List<Integer> found = new ArrayList<>(List.of(seed));
        Span span = line.span(parts.shape(seed));
        boolean grows = true;
        while (grows) {
            grows = false;
            near.clear();
            parts.overlapping(line.bounds(span).grown(2 * Tolerance.CRACK), near);
            for (int i = 0; i < near.size(); i++) {
                int part = near.get(i);
                if (!taken[part] && !found.contains(part) && line.holds(parts.shape(part), doubt)) {
                    found.add(part);
                    span = span.and(line.span(parts.shape(part)));
                    grows = true;
                }
            }
        }
        found.sort(null);
        return found;
    }

    /** Fits a line by least squares to the parts' points, in the frame of the previous line. */
    private Line fitted(Line line, List<Integer> members) {
        double weight = 0;
        double middleAlong = 0;
        double middleOff = 0;
        for (int member : members) {
            ConvexPolygon part = parts.shape(member);
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
            ConvexPolygon part = parts.shape(member);
            for (int end = 0; end < 2; end++) {
                double along = line.along(part, end) - middleAlong;
                square += part.length(0) * along * along;
                product += part.length(0) * along * (line.off(part, end) - middleOff);
            }
        }
        return line.moved(middleAlong, middleOff, product / square);
    }

    private ConvexPolygon innermost(Line line, List<Integer> members) {
        double inwards = Double.NEGATIVE_INFINITY;
        Span span = line.span(parts.shape(members.get(0)));
        for (int member : members) {
            ConvexPolygon part = parts.shape(member);
            inwards = Math.max(inwards, Math.max(line.off(part, 0), line.off(part, 1)));
            span = span.and(line.span(part));
        }
        return ConvexPolygon.of(new double[] {
            line.atX(span.from(), inwards),
            line.atY(span.from(), inwards),
            line.atX(span.to(), inwards),
            line.atY(span.to(), inwards)
        });
    }

    private record Span(double from, double to) {
        Span and(Span other) {
            return new Span(Math.min(from, other.from), Math.max(to, other.to));
        }
    }

    /** A line through (x, y) along the unit vector (dx, dy); offsets are positive to the left. */
    private record Line(double x, double y, double dx, double dy) {
        static Line along(ConvexPolygon part) {
            return new Line(part.x(0), part.y(0), -part.normalY(0), part.normalX(0));
        }

        double along(ConvexPolygon part, int end) {
            return (part.x(end) - x) * dx + (part.y(end) - y) * dy;
        }

        double off(ConvexPolygon part, int end) {
            return (part.y(end) - y) * dx - (part.x(end) - x) * dy;
        }

        double atX(double along, double off) {
            return x + along * dx - off * dy;
        }

        double atY(double along, double off) {
            return y + along * dy + off * dx;
        }

        Span span(ConvexPolygon part) {
            double a = along(part, 0);
            double b = along(part, 1);
            return new Span(Math.min(a, b), Math.max(a, b));
        }

        /**
         * Returns true if a part is on the line except for noise.
         *
         * @param doubt uncertainty of the line's slope in metres per metre: the permitted offset grows with the
         * distance
         */
        boolean holds(ConvexPolygon part, double doubt) {
            double cosine = -part.normalY(0) * dx + part.normalX(0) * dy;
            return isNear(part, 0, doubt) && isNear(part, 1, doubt) && cosine >= ALONG;
        }

        private boolean isNear(ConvexPolygon part, int end, double doubt) {
            return Math.abs(off(part, end)) <= NOISE + doubt * Math.abs(along(part, end));
        }

        Aabb bounds(Span span) {
            double fromX = atX(span.from(), 0);
            double fromY = atY(span.from(), 0);
            double toX = atX(span.to(), 0);
            double toY = atY(span.to(), 0);
            return new Aabb(
                    Math.min(fromX, toX), Math.min(fromY, toY), 0, Math.max(fromX, toX), Math.max(fromY, toY), 0);
        }

        Line moved(double along, double off, double slope) {
            double length = Math.sqrt(1 + slope * slope);
            return new Line(atX(along, off), atY(along, off), (dx - slope * dy) / length, (dy + slope * dx) / length);
        }
    }
}
