package nephele.engine.model;

import java.util.Arrays;
import java.util.List;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * A closed smooth curve that passes its points at equal steps of its parameter, 0 to 1, and repeats beyond. Each span is
 * the cubic with the points' positions and with the tangents of the parabola through each point and its neighbours
 * (Catmull and Rom 1974). Coincident points are allowed; a single point gives a constant curve.
 */
public final class CatmullRom {
    private final List<Vector3d> points;
    private final Vector3d[] tangents;

    /** Parameters of the points, and 1, where the first one comes again. */
    private final double[] knots;

    /** @throws IllegalArgumentException without any point, or for one that is not finite */
    public CatmullRom(List<Vec3> places) {
        if (places.isEmpty()) {
            throw new IllegalArgumentException("a curve needs a point");
        }
        for (Vec3 place : places) {
            if (!Double.isFinite(place.x() + place.y() + place.z())) {
                throw new IllegalArgumentException(place + " is no place for a curve");
            }
        }
        points = places.stream().map(Vec3::toVector).toList();
        knots = new double[points.size() + 1];
        Arrays.setAll(knots, i -> (double) i / points.size());
        tangents = new Vector3d[points.size()];
        Arrays.setAll(tangents, this::tangent);
    }

    /** Evaluates the position. Like the derivatives it allocates nothing. */
    public Vector3d position(double parameter, Vector3d into) {
        double at = wrapped(parameter);
        int from = spanOf(at);
        double span = span(from);
        double t = (at - knots[from]) / span;
        double u = 1 - t;
        return sum(from, (1 + 2 * t) * u * u, t * u * u * span, t * t * (3 - 2 * t), -t * t * u * span, into);
    }

    /** Evaluates the first derivative by the parameter; 0 where the curve is constant. */
    public Vector3d derivative(double parameter, Vector3d into) {
        double at = wrapped(parameter);
        int from = spanOf(at);
        double span = span(from);
        double t = (at - knots[from]) / span;
        double bend = 6 * t * t - 6 * t;
        return sum(from, bend / span, 3 * t * t - 4 * t + 1, -bend / span, 3 * t * t - 2 * t, into);
    }

    /** Evaluates the second derivative by the parameter; it is discontinuous at the points. */
    public Vector3d secondDerivative(double parameter, Vector3d into) {
        double at = wrapped(parameter);
        int from = spanOf(at);
        double span = span(from);
        double t = (at - knots[from]) / span;
        double bend = (12 * t - 6) / (span * span);
        return sum(from, bend, (6 * t - 4) / span, -bend, (6 * t - 2) / span, into);
    }

    /** Evaluates the Hermite form: the weighted positions and tangents of both ends of a span. */
    private Vector3d sum(int from, double start, double leaving, double end, double arriving, Vector3d into) {
        Vector3d after = tangents[(from + 1) % tangents.length];
        into.set(point(from)).mul(start);
        return into.fma(leaving, tangents[from]).fma(end, point(from + 1)).fma(arriving, after);
    }

    /** Returns the tangent of the parabola through a point and its neighbours. */
    private Vector3d tangent(int i) {
        double before = span(i - 1);
        double after = span(i);
        double sum = before + after;
        return chord(i - 1, before).mul(after / sum).fma(before / sum, chord(i, after));
    }

    private Vector3d chord(int from, double span) {
        return new Vector3d(point(from + 1)).sub(point(from)).div(span);
    }

    private Vector3d point(int i) {
        return points.get(Math.floorMod(i, points.size()));
    }

    /** Returns the length of the span after a point. */
    private double span(int i) {
        int span = Math.floorMod(i, points.size());
        return knots[span + 1] - knots[span];
    }

    /** Returns the parameter within the first round; NaN becomes the start. */
    private static double wrapped(double parameter) {
        double fraction = parameter - Math.floor(parameter);
        return fraction >= 0 && fraction < 1 ? fraction : 0;
    }

    /** Returns the span that contains a parameter. */
    private int spanOf(double at) {
        int found = Arrays.binarySearch(knots, at);
        int span = found >= 0 ? found : -found - 2;
        return Math.max(0, Math.min(span, points.size() - 1));
    }
}
