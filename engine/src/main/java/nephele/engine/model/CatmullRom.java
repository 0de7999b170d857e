package nephele.engine.model;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * A smooth curve through points. Each span is the cubic with the points' positions and with the tangents of the
 * parabola through each point and its neighbours; this is Barry and Goldman's Catmull-Rom curve (1988) for any knots.
 * Coincident points are allowed; a single point gives a constant curve.
 */
public final class CatmullRom {
    /** Shorter spans have meaningless tangents. */
    private static final double LEAST_SPAN = 1e-9;

    private final CurveKnots knots;
    private final Vector3d[] tangents;

    private CatmullRom(CurveKnots knots) {
        this.knots = knots;
        tangents = new Vector3d[knots.points().size()];
        for (int i = 0; i < tangents.length; i++) {
            tangents[i] = tangent(i);
        }
    }

    /** Creates a closed curve with equal spans over the parameter range 0 to 1; used for the paths of XML scenes. */
    public static CatmullRom uniformLoop(List<Vec3> points) {
        return new CatmullRom(CurveKnots.loop(points, 0));
    }

    /**
     * Creates a closed curve over the parameter range 0 to 1 without cusps and loops within a span (Yuksel, Schaefer
     * and Keyser 2011); used for the paths of levels.
     */
    public static CatmullRom centripetalLoop(List<Vec3> points) {
        return new CatmullRom(CurveKnots.loop(points, 0.5));
    }

    /** Creates a curve from the first point at 0 to the last at 1, with centripetal knots. */
    public static CatmullRom centripetal(List<Vec3> points) {
        return new CatmullRom(CurveKnots.open(points, 0.5));
    }

    /**
     * Creates a curve that is at each point at its time; of several points at one time the last counts.
     *
     * @throws IllegalArgumentException for times that decrease or are not finite, or without any point
     */
    public static CatmullRom timed(List<Vec3> points, double[] seconds) {
        return new CatmullRom(CurveKnots.timed(points, seconds));
    }

    /**
     * Evaluates the position. Outside the parameter range a closed curve repeats and an open one is constant. Like the
     * derivatives it allocates nothing.
     */
    public Vector3d position(double parameter, Vector3d into) {
        double at = knots.wrapOrClamp(parameter);
        int from = knots.spanOf(at);
        double span = knots.span(from);
        if (span < LEAST_SPAN) {
            return into.set(knots.point(from));
        }
        double t = (at - knots.knot(from)) / span;
        double u = 1 - t;
        return sum(from, (1 + 2 * t) * u * u, t * u * u * span, t * t * (3 - 2 * t), -t * t * u * span, into);
    }

    /** Evaluates the first derivative by the parameter; 0 where the curve is constant. */
    public Vector3d derivative(double parameter, Vector3d into) {
        double at = knots.wrapOrClamp(parameter);
        int from = knots.spanOf(at);
        double span = knots.span(from);
        if (stands(parameter, at, span)) {
            return into.zero();
        }
        double t = (at - knots.knot(from)) / span;
        double bend = 6 * t * t - 6 * t;
        return sum(from, bend / span, 3 * t * t - 4 * t + 1, -bend / span, 3 * t * t - 2 * t, into);
    }

    /** Evaluates the second derivative by the parameter; it is discontinuous at knots. */
    public Vector3d secondDerivative(double parameter, Vector3d into) {
        double at = knots.wrapOrClamp(parameter);
        int from = knots.spanOf(at);
        double span = knots.span(from);
        if (stands(parameter, at, span)) {
            return into.zero();
        }
        double t = (at - knots.knot(from)) / span;
        double bend = (12 * t - 6) / (span * span);
        return sum(from, bend, (6 * t - 4) / span, -bend, (6 * t - 2) / span, into);
    }

    private boolean stands(double parameter, double at, double span) {
        return span < LEAST_SPAN || at != parameter && !knots.closed();
    }

    /** Evaluates the Hermite form: the weighted positions and tangents of both ends of a span. */
    private Vector3d sum(int from, double start, double leaving, double end, double arriving, Vector3d into) {
        Vector3d after = tangents[(from + 1) % tangents.length];
        into.set(knots.point(from)).mul(start);
        return into.fma(leaving, tangents[from]).fma(end, knots.point(from + 1)).fma(arriving, after);
    }

    /**
     * Returns the tangent of the parabola through a point and its neighbours; at an end, towards the only neighbour.
     */
    private Vector3d tangent(int i) {
        boolean first = !knots.closed() && i == 0;
        boolean last = !knots.closed() && i == knots.spans();
        double before = first ? 0 : knots.span(i - 1);
        double after = last ? 0 : knots.span(i);
        Vector3d arriving = before < LEAST_SPAN ? new Vector3d() : chord(i - 1, before);
        Vector3d leaving = after < LEAST_SPAN ? new Vector3d() : chord(i, after);
        if (before < LEAST_SPAN || after < LEAST_SPAN) {
            return arriving.add(leaving);
        }
        double sum = before + after;
        return arriving.mul(after / sum).fma(before / sum, leaving);
    }

    private Vector3d chord(int from, double span) {
        return new Vector3d(knots.point(from + 1)).sub(knots.point(from)).div(span);
    }

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
}
