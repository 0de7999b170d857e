package nephele.engine.reference;

import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.BoxTest;

/**
 * The space that shadow rays from one box may pass: at parameter t from 0 to {@code end} the box with every bound moved
 * by t times its own rate. It is wider than the rays by far more than the rounding errors.
 */
final class ShaftShape implements BoxTest {
    /** Metres, and metres per unit of the parameter. */
    private static final double MARGIN = 1e-4;

    private final double[] low;
    private final double[] high;
    private final double[] lowRate;
    private final double[] highRate;
    private final double end;

    private ShaftShape(Aabb from, double[] lowRate, double[] highRate, double end) {
        Aabb wide = from.grown(MARGIN);
        low = new double[] {wide.minX(), wide.minY(), wide.minZ()};
        high = new double[] {wide.maxX(), wide.maxY(), wide.maxZ()};
        this.lowRate = lowRate;
        this.highRate = highRate;
        this.end = end;
    }

    /** Returns the shaft to a punctual light. */
    static ShaftShape to(Vec3 light, Aabb from) {
        double[] lowRate = {light.x() - from.minX(), light.y() - from.minY(), light.z() - from.minZ()};
        double[] highRate = {light.x() - from.maxX(), light.y() - from.maxY(), light.z() - from.maxZ()};
        return new ShaftShape(from, lowRate, highRate, 1);
    }

    /** Returns the unbounded shaft of all directions between two, component by component. */
    static ShaftShape along(Vec3 least, Vec3 most, Aabb from) {
        double[] lowRate = {least.x() - MARGIN, least.y() - MARGIN, least.z() - MARGIN};
        double[] highRate = {most.x() + MARGIN, most.y() + MARGIN, most.z() + MARGIN};
        return new ShaftShape(from, lowRate, highRate, Double.POSITIVE_INFINITY);
    }

    @Override
    public boolean passes(double[] bounds, int at) {
        return entry(bounds, at) < Double.POSITIVE_INFINITY;
    }

    /** Returns the parameter at which the shaft first intersects a box; infinity if it does not. */
    double entry(double[] bounds, int at) {
        double enter = 0;
        double leave = end;
        for (int axis = 0; axis < 3; axis++) {
            double below = bounds[at + axis] - high[axis];
            double above = bounds[at + 3 + axis] - low[axis];
            double highMoves = highRate[axis];
            double lowMoves = lowRate[axis];
            if (highMoves > 0) {
                enter = Math.max(enter, below / highMoves);
            } else if (highMoves < 0) {
                leave = Math.min(leave, below / highMoves);
            } else if (below > 0) {
                return Double.POSITIVE_INFINITY;
            }
            if (lowMoves > 0) {
                leave = Math.min(leave, above / lowMoves);
            } else if (lowMoves < 0) {
                enter = Math.max(enter, above / lowMoves);
            } else if (above < 0) {
                return Double.POSITIVE_INFINITY;
            }
        }
        return enter <= leave ? enter : Double.POSITIVE_INFINITY;
    }
}
