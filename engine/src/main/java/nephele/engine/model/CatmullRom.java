package nephele.engine.model;

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
}
