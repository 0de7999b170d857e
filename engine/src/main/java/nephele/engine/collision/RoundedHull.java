package nephele.engine.collision;

import nephele.engine.collision.Gjk.SupportPoints;
import nephele.engine.math.Vec3;

/**
 * A moving shape: the convex hull of a few core points, inflated by a radius. A sphere has one core point, a capsule
 * two, a box eight and no radius. Core points are relative to the shape's own origin.
 */
public final class RoundedHull implements SupportPoints {
    private final double[] core;
    private final double radiusMetres;
    private final double reachMetres;
    private final double[] least = new double[3];
    private final double[] greatest = new double[3];

    private RoundedHull(double[] core, double radiusMetres) {
        this.core = core;
        this.radiusMetres = radiusMetres;
        double square = 0;
        for (int i = 0; i < core.length; i += 3) {
            square = Math.max(square, core[i] * core[i] + core[i + 1] * core[i + 1] + core[i + 2] * core[i + 2]);
        }
        reachMetres = Math.sqrt(square) + radiusMetres;
        bound();
    }

    private void bound() {
        for (int axis = 0; axis < 3; axis++) {
            least[axis] = Double.POSITIVE_INFINITY;
            greatest[axis] = Double.NEGATIVE_INFINITY;
            for (int i = axis; i < core.length; i += 3) {
                least[axis] = Math.min(least[axis], core[i] - radiusMetres);
                greatest[axis] = Math.max(greatest[axis], core[i] + radiusMetres);
            }
        }
    }

    /** Returns a sphere about the origin. */
    public static RoundedHull sphere(double radiusMetres) {
        return new RoundedHull(new double[3], radiusMetres);
    }

    /** Returns a capsule of any orientation: its axis runs from −{@code halfAxis} to +{@code halfAxis}. */
    public static RoundedHull capsule(Vec3 halfAxis, double radiusMetres) {
        double[] ends = {-halfAxis.x(), -halfAxis.y(), -halfAxis.z(), halfAxis.x(), halfAxis.y(), halfAxis.z()};
        return new RoundedHull(ends, radiusMetres);
    }

    /** Returns an upright capsule from its whole height, caps included; the origin is its centre. */
    public static RoundedHull uprightCapsule(double radiusMetres, double heightMetres) {
        return capsule(new Vec3(0, heightMetres / 2 - radiusMetres, 0), radiusMetres);
    }

    /** Returns a box of any orientation from its half edges, which need not be axis-aligned. */
    public static RoundedHull box(Vec3 halfX, Vec3 halfY, Vec3 halfZ) {
        double[] corners = new double[24];
        for (int i = 0; i < 8; i++) {
            int sx = (i & 1) == 0 ? -1 : 1;
            int sy = (i & 2) == 0 ? -1 : 1;
            int sz = (i & 4) == 0 ? -1 : 1;
            corners[3 * i] = sx * halfX.x() + sy * halfY.x() + sz * halfZ.x();
            corners[3 * i + 1] = sx * halfX.y() + sy * halfY.y() + sz * halfZ.y();
            corners[3 * i + 2] = sx * halfX.z() + sy * halfY.z() + sz * halfZ.z();
        }
        return new RoundedHull(corners, 0);
    }

    /** Returns a copy that can be given another orientation by {@link #turn}. */
    public RoundedHull copy() {
        return new RoundedHull(core.clone(), radiusMetres);
    }

    /**
     * Sets this shape to another one rotated. Only for an owner that keeps one shape for many queries and does not
     * share it.
     *
     * @param axes from {@code at} on nine numbers: the directions of the axes x, y and z of the upright shape
     */
    public void turn(RoundedHull upright, double[] axes, int at) {
        for (int i = 0; i < core.length; i += 3) {
            double x = upright.core[i];
            double y = upright.core[i + 1];
            double z = upright.core[i + 2];
            for (int axis = 0; axis < 3; axis++) {
                core[i + axis] = axes[at + axis] * x + axes[at + 3 + axis] * y + axes[at + 6 + axis] * z;
            }
        }
        bound();
    }

    public double radiusMetres() {
        return radiusMetres;
    }

    /** Returns the greatest distance of the shape from its origin. */
    public double reachMetres() {
        return reachMetres;
    }

    /** Returns the greatest ({@code sign} 1) or least (−1) coordinate along a unit axis, radius included. */
    public double support(int sign, Vec3 axis) {
        int point = least(-sign * axis.x(), -sign * axis.y(), -sign * axis.z());
        double along = core(point, 0) * axis.x() + core(point, 1) * axis.y() + core(point, 2) * axis.z();
        return along + sign * radiusMetres;
    }

    public int corePoints() {
        return core.length / 3;
    }

    /** Returns component {@code axis} (0, 1, 2) of a core point. */
    public double core(int point, int axis) {
        return core[3 * point + axis];
    }

    /** Returns the greatest coordinate along an axis (0, 1, 2), radius included. */
    public double greatest(int axis) {
        return greatest[axis];
    }

    /** Returns the least coordinate along an axis (0, 1, 2), radius included. */
    public double least(int axis) {
        return least[axis];
    }

    /** Returns the index of the core point least far along a direction. */
    int least(double x, double y, double z) {
        int best = 0;
        double bestDot = Double.POSITIVE_INFINITY;
        for (int i = 0; i < core.length; i += 3) {
            double dot = core[i] * x + core[i + 1] * y + core[i + 2] * z;
            if (dot < bestDot) {
                bestDot = dot;
                best = i / 3;
            }
        }
        return best;
    }

    @Override
    public int farthest(double x, double y, double z) {
        return least(-x, -y, -z);
    }

    @Override
    public double vertex(int point, int axis) {
        return core[3 * point + axis];
    }
}
