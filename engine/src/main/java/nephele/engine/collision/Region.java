package nephele.engine.collision;

import org.joml.Vector3dc;

/** A box that a query looks into; reused, where an {@code Aabb} would be allocated. */
final class Region {
    private final double[] low = new double[3];
    private final double[] high = new double[3];

    /** All places that a shape touches on its way, and a margin around them. */
    void sweep(RoundedHull shape, Vector3dc from, Vector3dc displacement, double marginMetres) {
        for (int axis = 0; axis < 3; axis++) {
            double reach = shape.reach(axis) + marginMetres;
            double start = from.get(axis);
            double end = start + displacement.get(axis);
            low[axis] = Math.min(start, end) - reach;
            high[axis] = Math.max(start, end) + reach;
        }
    }

    /** @param bounds three minima and three maxima from {@code offset} on */
    boolean meets(double[] bounds, int offset) {
        return low[0] <= bounds[offset + 3]
                && bounds[offset] <= high[0]
                && low[1] <= bounds[offset + 4]
                && bounds[offset + 1] <= high[1]
                && low[2] <= bounds[offset + 5]
                && bounds[offset + 2] <= high[2];
    }
}
