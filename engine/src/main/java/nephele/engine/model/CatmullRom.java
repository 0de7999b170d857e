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

    /** Minimum distance of two knots relative to the longest; coincident points still get a span. */
    private static final double LEAST_FRACTION = 1e-3;

    private final List<Vector3d> points;

    /** Parameters of the knots, one more than there are spans, increasing; a closed curve's last is its first point. */
    private final double[] knots;

    private final boolean isClosed;
    private final Vector3d[] tangents;

    private CatmullRom(List<Vector3d> points, double[] knots, boolean isClosed) {
        this.points = points;
        this.knots = knots;
        this.isClosed = isClosed;
        tangents = new Vector3d[points.size()];
        for (int i = 0; i < tangents.length; i++) {
            tangents[i] = tangent(i);
        }
    }

    /** Creates a closed curve with equal spans over the parameter range 0 to 1; used for the paths of XML scenes. */
    public static CatmullRom uniformLoop(List<Vec3> points) {
        return loop(points, 0);
    }

    /**
     * Creates a closed curve over the parameter range 0 to 1 without cusps and loops within a span (Yuksel, Schaefer
     * and Keyser 2011); used for the paths of levels.
     */
    public static CatmullRom centripetalLoop(List<Vec3> points) {
        return loop(points, 0.5);
    }

    /** Creates a curve from the first point at 0 to the last at 1, with centripetal knots. */
    public static CatmullRom centripetal(List<Vec3> places) {
        List<Vector3d> points = vectors(places);
        double[] spans = new double[points.size() - 1];
        for (int i = 0; i < spans.length; i++) {
            spans[i] = power(points.get(i).distance(points.get(i + 1)), 0.5);
        }
        return new CatmullRom(points, fractions(spans), false);
    }

    /**
     * Creates a curve that is at each point at its time; of several points at one time the last counts.
     *
     * @throws IllegalArgumentException for times that decrease or are not finite, or without any point
     */
    public static CatmullRom timed(List<Vec3> places, double[] seconds) {
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
        return new CatmullRom(points, Arrays.copyOf(knots, points.size()), false);
    }

    /**
     * Evaluates the position. Outside the parameter range a closed curve repeats and an open one is constant. Like the
     * derivatives it allocates nothing.
     */
    public Vector3d position(double parameter, Vector3d into) {
        double at = wrapOrClamp(parameter);
        int from = spanOf(at);
        double span = span(from);
        if (span < LEAST_SPAN) {
            return into.set(point(from));
        }
        double t = (at - knot(from)) / span;
        double u = 1 - t;
        return sum(from, (1 + 2 * t) * u * u, t * u * u * span, t * t * (3 - 2 * t), -t * t * u * span, into);
    }

    /** Evaluates the first derivative by the parameter; 0 where the curve is constant. */
    public Vector3d derivative(double parameter, Vector3d into) {
        double at = wrapOrClamp(parameter);
        int from = spanOf(at);
        double span = span(from);
        if (stands(parameter, at, span)) {
            return into.zero();
        }
        double t = (at - knot(from)) / span;
        double bend = 6 * t * t - 6 * t;
        return sum(from, bend / span, 3 * t * t - 4 * t + 1, -bend / span, 3 * t * t - 2 * t, into);
    }

    /** Evaluates the second derivative by the parameter; it is discontinuous at knots. */
    public Vector3d secondDerivative(double parameter, Vector3d into) {
        double at = wrapOrClamp(parameter);
        int from = spanOf(at);
        double span = span(from);
        if (stands(parameter, at, span)) {
            return into.zero();
        }
        double t = (at - knot(from)) / span;
        double bend = (12 * t - 6) / (span * span);
        return sum(from, bend, (6 * t - 4) / span, -bend, (6 * t - 2) / span, into);
    }

    private boolean stands(double parameter, double at, double span) {
        return span < LEAST_SPAN || at != parameter && !isClosed;
    }

    /** Evaluates the Hermite form: the weighted positions and tangents of both ends of a span. */
    private Vector3d sum(int from, double start, double leaving, double end, double arriving, Vector3d into) {
        Vector3d after = tangents[(from + 1) % tangents.length];
        into.set(point(from)).mul(start);
        return into.fma(leaving, tangents[from]).fma(end, point(from + 1)).fma(arriving, after);
    }

    /**
     * Returns the tangent of the parabola through a point and its neighbours; at an end, towards the only neighbour.
     */
    private Vector3d tangent(int i) {
        boolean first = !isClosed && i == 0;
        boolean last = !isClosed && i == spans();
        double before = first ? 0 : span(i - 1);
        double after = last ? 0 : span(i);
        Vector3d arriving = before < LEAST_SPAN ? new Vector3d() : chord(i - 1, before);
        Vector3d leaving = after < LEAST_SPAN ? new Vector3d() : chord(i, after);
        if (before < LEAST_SPAN || after < LEAST_SPAN) {
            return arriving.add(leaving);
        }
        double sum = before + after;
        return arriving.mul(after / sum).fma(before / sum, leaving);
    }

    private Vector3d chord(int from, double span) {
        return new Vector3d(point(from + 1)).sub(point(from)).div(span);
    }

    /** @param exponent of the chord length in the knot distance: 0 uniform, 1/2 centripetal */
    private static CatmullRom loop(List<Vec3> places, double exponent) {
        List<Vector3d> points = vectors(places);
        double[] spans = new double[points.size()];
        for (int i = 0; i < spans.length; i++) {
            spans[i] = power(points.get(i).distance(points.get((i + 1) % points.size())), exponent);
        }
        return new CatmullRom(points, fractions(spans), true);
    }

    /** Returns the parameter at which the curve passes a point. */
    double knot(int i) {
        return knots[i];
    }

    private int spans() {
        return knots.length - 1;
    }

    private Vector3d point(int i) {
        return points.get(isClosed ? Math.floorMod(i, points.size()) : i);
    }

    /** Returns the length of the span after point {@code i}; 0 if the curve has no span. */
    private double span(int i) {
        if (spans() == 0) {
            return 0;
        }
        int span = isClosed ? Math.floorMod(i, spans()) : i;
        return knots[span + 1] - knots[span];
    }

    /** Maps a parameter to the curve: wrapped if closed, otherwise clamped; NaN maps to the start. */
    private double wrapOrClamp(double parameter) {
        double first = knots[0];
        double last = knots[spans()];
        if (Double.isNaN(parameter) || last <= first) {
            return first;
        }
        if (!isClosed) {
            return Math.min(Math.max(parameter, first), last);
        }
        double turns = (parameter - first) / (last - first);
        double fraction = turns - Math.floor(turns);
        return fraction >= 0 && fraction < 1 ? first + fraction * (last - first) : first;
    }

    /** Returns the span that contains a parameter; the end of the curve belongs to the last span. */
    private int spanOf(double at) {
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
    private static double[] fractions(double[] spans) {
        double longest = Arrays.stream(spans).max().orElse(0);
        double least = longest > 0 ? LEAST_FRACTION * longest : 1;
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
