package nephele.engine.portal.placement;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.bvh.ItemList;

/**
 * Makes one straight segment of outline parts that follow each other along one line but for noise. A wall's edge that
 * was cut into pieces is one edge again: without that, noise of 10 µm on a piece of 1 cm would turn the way in which a
 * portal slides by a thousandth, and move it by as much of the slide. A segment lies where the innermost of its parts do.
 * The longest part leads; as noise in its ends tilts it, others are looked for the farther off its line the farther along
 * they are, and kept if they lie on the line through all of them.
 */
final class OutlineSimplification {
    /** Metres off the common line that count as noise. */
    private static final double NOISE = Tolerance.CRACK / 2;

    /** Cosine between the line and a part of it. */
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

    /** @param doubt at first about the slope of the seed's own line, as {@link Line#holds} takes it */
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

    /** Parts on the line from one to the next, in ascending order. */
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

    /** Least squares over the parts' points, in the frame of the line so far. */
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

    /** Through (x, y) along the unit vector (dx, dy); off it counts to the left. */
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
         * Whether a part lies on the line but for noise.
         *
         * @param doubt about the line's slope, in metres a metre: how much farther off parts may be as they are farther away
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
