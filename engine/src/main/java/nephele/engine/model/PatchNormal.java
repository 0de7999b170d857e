package nephele.engine.model;

import org.joml.Vector3d;

/**
 * Outward unit normals of a patch: the cross product of its derivatives, or its limit where they vanish or are parallel,
 * as at the tip of the Utah teapot, where a whole edge of a patch is one point.
 */
final class PatchNormal {
    /** Relative to the patch's size, squared as a cross product is. */
    private static final double VANISHING = 1e-12;

    private static final double[] STEPS_INWARD = {1e-4, 1e-3, 1e-2, 1e-1};

    private final BezierPatch patch;
    private final double vanishing;

    PatchNormal(BezierPatch patch) {
        this.patch = patch;
        this.vanishing = VANISHING * squaredSize(patch);
    }

    /** @param cross product of the derivatives; may be changed */
    Vector3d unit(Vector3d cross, int column, int row, int parts) {
        if (cross.length() > vanishing) {
            return cross.normalize();
        }
        CubicWeights u = CubicWeights.at(column, parts);
        CubicWeights v = CubicWeights.at(row, parts);
        Vector3d normal = secondOrder(u, v, column == parts ? -1 : 1, row == parts ? -1 : 1);
        return normal.length() > vanishing ? normal.normalize() : inward((double) column / parts, (double) row / parts);
    }

    private Vector3d cross(CubicWeights u, CubicWeights v) {
        return patch.weighted(u.slope(), v.value()).cross(patch.weighted(u.value(), v.slope()));
    }

    /**
     * A step s into the patch the derivative that is 0 at its edge is s times the mixed one, which thus takes its place;
     * from the far edge the step is a negative one.
     */
    private Vector3d secondOrder(CubicWeights u, CubicWeights v, int intoColumns, int intoRows) {
        Vector3d alongU = patch.weighted(u.slope(), v.value());
        Vector3d alongV = patch.weighted(u.value(), v.slope());
        Vector3d mixed = patch.weighted(u.slope(), v.slope());
        return alongU.length() < alongV.length()
                ? mixed.mul(intoRows).cross(alongV)
                : alongU.cross(mixed.mul(intoColumns));
    }

    /** What the normal tends to on the way to the middle; +y where the patch is a line or a point. */
    private Vector3d inward(double u, double v) {
        for (double step : STEPS_INWARD) {
            Vector3d normal = cross(CubicWeights.at(u + step * (0.5 - u)), CubicWeights.at(v + step * (0.5 - v)));
            if (normal.length() > vanishing) {
                return normal.normalize();
            }
        }
        return new Vector3d(0, 1, 0);
    }

    private static double squaredSize(BezierPatch patch) {
        double most = 0;
        for (Vector3d point : patch.points()) {
            most = Math.max(most, point.distanceSquared(patch.points()[0]));
        }
        return most;
    }
}
