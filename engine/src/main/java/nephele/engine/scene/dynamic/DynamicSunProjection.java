package nephele.engine.scene.dynamic;

import nephele.engine.math.Vec3;
import org.joml.Matrix4d;
import org.joml.Vector3d;

/**
 * The parallel projection of the sun's depth map for dynamic objects. It contains all of them, or only those near the
 * eye if its texels would become too large. Texels are aligned to a grid fixed in the world, and their size changes in
 * steps, so that a shadow's edge does not crawl while another object moves. One object serves all frames.
 */
public final class DynamicSunProjection {
    private static final double FINEST_TEXEL_METRES = 0.005;
    /** Large, because portals also show shadows far from the eye; objects there have to remain in the map for long. */
    private static final double COARSEST_TEXEL_METRES = 0.06;
    /** Empty texels around the casters, which the filter may read. */
    private static final int MARGIN_TEXELS = 3;

    private final int side;
    private final Vector3d right = new Vector3d();
    private final Vector3d up = new Vector3d();
    private final Vector3d back = new Vector3d();
    private Vec3 towardsSun;
    private final double[] low = new double[3];
    private final double[] high = new double[3];
    private double texel = FINEST_TEXEL_METRES;
    private int width;
    private int height;
    /** True if objects far from {@link #fittedTo} were left out. */
    private boolean isLimited;

    private Vec3 fittedTo = Vec3.ZERO;

    /**
     * Makes the projection.
     *
     * @param side texels along each side of the map
     */
    public DynamicSunProjection(int side) {
        this.side = side;
    }

    /**
     * Sets the sun's direction.
     *
     * @param newTowardsSun any length but zero
     */
    public void turn(Vec3 newTowardsSun) {
        towardsSun = newTowardsSun;
        back.set(towardsSun.toVector().normalize());
        right.set(Math.abs(back.y) < 0.999 ? new Vector3d(0, 1, 0).cross(back).normalize() : new Vector3d(1, 0, 0));
        right.fma(-right.dot(back), back).normalize();
        back.cross(right, up);
    }

    /** Returns the direction last set; {@code null} before. */
    public Vec3 towardsSun() {
        return towardsSun;
    }

    /** Fits the map to all instances, or to those that fit into a map of the coarsest texels around {@code eye}. */
    public void fit(DynamicInstances copies, Vec3 eye) {
        bound(copies, eye, Double.POSITIVE_INFINITY);
        double widest = Math.max(high[0] - low[0], high[1] - low[1]);
        isLimited = widest > (side - 2 * MARGIN_TEXELS - 1) * COARSEST_TEXEL_METRES;
        fittedTo = eye;
        if (isLimited) {
            bound(copies, eye, (side / 2 - MARGIN_TEXELS - 1) * COARSEST_TEXEL_METRES);
            widest = Math.max(high[0] - low[0], high[1] - low[1]);
        }
        texel = FINEST_TEXEL_METRES;
        while (texel < COARSEST_TEXEL_METRES && widest > (side - 2 * MARGIN_TEXELS - 1) * texel) {
            texel = Math.min(texel * Math.sqrt(2), COARSEST_TEXEL_METRES);
        }
        width = snap(0);
        height = snap(1);
        low[2] -= 0.05;
        high[2] += 0.05;
    }

    /** Returns true if the map is limited and the eye has moved so far that other objects are near it now. */
    public boolean isOutgrown(Vec3 eye) {
        double metres = side * COARSEST_TEXEL_METRES / 16;
        return isLimited && eye.toVector().distanceSquared(fittedTo.x(), fittedTo.y(), fittedTo.z()) > metres * metres;
    }

    /** Bounds the casters along the map's axes; without casters the ranges are empty. */
    private void bound(DynamicInstances copies, Vec3 eye, double within) {
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = Double.POSITIVE_INFINITY;
            high[axis] = Double.NEGATIVE_INFINITY;
        }
        for (int i = 0; i < copies.instances(); i++) {
            double x = copies.ball(i, 0);
            double y = copies.ball(i, 1);
            double z = copies.ball(i, 2);
            double radius = copies.ball(i, 3);
            double aside = Math.abs(right.dot(x - eye.x(), y - eye.y(), z - eye.z()));
            double above = Math.abs(up.dot(x - eye.x(), y - eye.y(), z - eye.z()));
            if (Math.max(aside, above) + radius <= within) {
                stretch(0, right.dot(x, y, z), radius);
                stretch(1, up.dot(x, y, z), radius);
                stretch(2, back.dot(x, y, z), radius);
            }
        }
    }

    private void stretch(int axis, double middle, double radius) {
        low[axis] = Math.min(low[axis], middle - radius);
        high[axis] = Math.max(high[axis], middle + radius);
    }

    /**
     * Extends a range to the grid.
     *
     * @return its length in texels, at most {@link #side}
     */
    private int snap(int axis) {
        if (low[axis] > high[axis]) {
            return 0;
        }
        double first = Math.floor(low[axis] / texel) - MARGIN_TEXELS;
        double last = Math.ceil(high[axis] / texel) + MARGIN_TEXELS;
        low[axis] = first * texel;
        high[axis] = last * texel;
        return (int) Math.min(side, last - first);
    }

    /** Returns the number of texels in use along a row; 0 without casters. */
    public int width() {
        return width;
    }

    public int height() {
        return height;
    }

    public double texelMetres() {
        return texel;
    }

    /** Returns the distance spanned by depth 0 to 1, metres; depth increases away from the sun. */
    public double depthMetres() {
        return high[2] - low[2];
    }

    public Vector3d right() {
        return right;
    }

    public Vector3d up() {
        return up;
    }

    /** Returns the matrix from metres relative to {@code anchor} to texture coordinates and depth, all 0 to 1. */
    public Matrix4d mapFromAnchor(Vec3 anchor, Matrix4d out) {
        double across = 1 / (side * texel);
        double deep = 1 / depthMetres();
        return out.set(
                right.x * across,
                up.x * across,
                -back.x * deep,
                0,
                right.y * across,
                up.y * across,
                -back.y * deep,
                0,
                right.z * across,
                up.z * across,
                -back.z * deep,
                0,
                (right.dot(anchor.x(), anchor.y(), anchor.z()) - low[0]) * across,
                (up.dot(anchor.x(), anchor.y(), anchor.z()) - low[1]) * across,
                (high[2] - back.dot(anchor.x(), anchor.y(), anchor.z())) * deep,
                1);
    }
}
