package nephele.engine.model;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * The points of a curve and the parameters of its knots. The last knot of a closed curve is its first point again.
 *
 * @param knots one more than there are spans, increasing
 */
record CurveKnots(List<Vector3d> points, double[] knots, boolean closed) {
    /** Minimum distance of two knots relative to the longest; coincident points still get a span. */
    private static final double LEAST_SHARE = 1e-3;

    /** @param exponent of the chord length in the knot distance: 0 uniform, 1/2 centripetal */
    static CurveKnots loop(List<Vec3> places, double exponent) {
        List<Vector3d> points = vectors(places);
        double[] spans = new double[points.size()];
        for (int i = 0; i < spans.length; i++) {
            spans[i] = power(points.get(i).distance(points.get((i + 1) % points.size())), exponent);
        }
        return new CurveKnots(points, shares(spans), true);
    }

    static CurveKnots open(List<Vec3> places, double exponent) {
        List<Vector3d> points = vectors(places);
        double[] spans = new double[points.size() - 1];
        for (int i = 0; i < spans.length; i++) {
            spans[i] = power(points.get(i).distance(points.get(i + 1)), exponent);
        }
        return new CurveKnots(points, shares(spans), false);
    }

    static CurveKnots timed(List<Vec3> places, double[] seconds) {
        List<Vector3d> all = vectors(places);
        if (seconds.length != all.size()) {
            throw new IllegalArgumentException(all.size() + " points need as many times, not " + seconds.length);
        }
        List<Vector3d> points = new ArrayList<>();
        double[] knots = new double[seconds.length];
        for (int i = 0; i < seconds.length; i++) {
            checkTime(seconds, i);
            boolean replaced = i + 1 < seconds.length && seconds[i + 1] == seconds[i];
            if (!replaced) {
                knots[points.size()] = seconds[i];
                points.add(all.get(i));
            }
        }
        return new CurveKnots(points, Arrays.copyOf(knots, points.size()), false);
    }

    int spans() {
        return knots.length - 1;
    }

    Vector3d point(int i) {
        return points.get(closed ? Math.floorMod(i, points.size()) : i);
    }

    double knot(int i) {
        return knots[i];
    }

    /** Returns the length of the span after point {@code i}; 0 if the curve has no span. */
    double span(int i) {
        if (spans() == 0) {
            return 0;
        }
        int span = closed ? Math.floorMod(i, spans()) : i;
        return knots[span + 1] - knots[span];
    }

    /** Maps a parameter to the curve: wrapped if closed, otherwise clamped; NaN maps to the start. */
    double wrapOrClamp(double parameter) {
        double first = knots[0];
        double last = knots[spans()];
        if (Double.isNaN(parameter) || last <= first) {
            return first;
        }
        if (!closed) {
            return Math.min(Math.max(parameter, first), last);
        }
        double turns = (parameter - first) / (last - first);
        double share = turns - Math.floor(turns);
        return share >= 0 && share < 1 ? first + share * (last - first) : first;
    }

    /** Returns the span that contains a parameter; the end of the curve belongs to the last span. */
    int spanOf(double at) {
        int found = Arrays.binarySearch(knots, at);
        int span = found >= 0 ? found : -found - 2;
        return Math.max(0, Math.min(span, spans() - 1));
    }

    private static List<Vector3d> vectors(List<Vec3> places) {
        if (places.isEmpty()) {
            throw new IllegalArgumentException("a curve needs a point");
        }
        for (Vec3 place : places) {
            if (!Double.isFinite(place.x() + place.y() + place.z())) {
                throw new IllegalArgumentException(place + " is no place for a curve");
            }
        }
        return places.stream().map(Vec3::toVector).toList();
    }

    private static void checkTime(double[] seconds, int i) {
        if (!Double.isFinite(seconds[i])) {
            throw new IllegalArgumentException("time " + (i + 1) + " is no number");
        }
        if (i > 0 && seconds[i] < seconds[i - 1]) {
            throw new IllegalArgumentException(
                    "time " + (i + 1) + " (" + seconds[i] + " s) is before the one in front of it");
        }
    }

    private static double power(double chord, double exponent) {
        return exponent == 0 ? 1 : StrictMath.pow(chord, exponent);
    }

    /** Returns knots from 0 to 1 with distances proportional to {@code spans}. */
    private static double[] shares(double[] spans) {
        double longest = Arrays.stream(spans).max().orElse(0);
        double least = longest > 0 ? LEAST_SHARE * longest : 1;
        double[] knots = new double[spans.length + 1];
        for (int i = 0; i < spans.length; i++) {
            knots[i + 1] = knots[i] + Math.max(spans[i], least);
        }
        double sum = Math.max(knots[spans.length], Double.MIN_NORMAL);
        for (int i = 1; i < knots.length; i++) {
            knots[i] = i == spans.length ? 1 : knots[i] / sum;
        }
        return knots;
    }
}
