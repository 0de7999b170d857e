package nephele.engine.cloud;

import java.util.OptionalDouble;
import nephele.engine.math.Ray;

/** Optical depth, the integral of the extinction along a ray: transmittance is its negative exponential. */
public final class OpticalDepth {
    /** Abscissae and weights of five-point Gauss-Legendre quadrature on −1 to 1. */
    private static final double[] NODES = {
        -0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831, 0.9061798459386640
    };

    private static final double[] WEIGHTS = {
        0.2369268850561891, 0.4786286704993665, 0.5688888888888889, 0.4786286704993665, 0.2369268850561891
    };

    private OpticalDepth() {}

    /**
     * Returns the optical depth of a part of a ray: in closed form where the field has one, otherwise by {@link
     * #quadrature} with 8 panels a segment.
     *
     * @param ray of unit direction
     * @param toMetres finite if the field is infinite
     */
    public static double along(ExtinctionField field, Ray ray, double fromMetres, double toMetres) {
        OptionalDouble closed = field.closedDepth(ray, fromMetres, toMetres);
        return closed.isPresent() ? closed.getAsDouble() : quadrature(field, ray, fromMetres, toMetres, 8);
    }

    /** Returns the optical depth by Gauss-Legendre quadrature on equal panels of each segment of the field's walk. */
    public static double quadrature(
            ExtinctionField field, Ray ray, double fromMetres, double toMetres, int panelsPerSegment) {
        MajorantWalk walk = field.walk(ray, fromMetres, toMetres);
        double sum = 0;
        while (walk.next()) {
            double half = (walk.toMetres() - walk.fromMetres()) / panelsPerSegment / 2;
            for (int panel = 0; panel < panelsPerSegment; panel++) {
                sum += half * panel(field, ray, walk.fromMetres() + (2 * panel + 1) * half, half);
            }
        }
        return sum;
    }

    private static double panel(ExtinctionField field, Ray ray, double middle, double half) {
        double sum = 0;
        for (int node = 0; node < NODES.length; node++) {
            double at = middle + half * NODES[node];
            sum += WEIGHTS[node]
                    * field.perMetre(
                            ray.originX() + at * ray.directionX(),
                            ray.originY() + at * ray.directionY(),
                            ray.originZ() + at * ray.directionZ());
        }
        return sum;
    }
}
