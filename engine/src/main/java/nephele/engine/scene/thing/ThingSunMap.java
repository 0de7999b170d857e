package nephele.engine.scene.thing;

import nephele.engine.math.Vec3;
import org.joml.Matrix4d;
import org.joml.Vector3d;

/**
 * The parallel projection of the sun's depth map of what moves: around all of it, or around what is near the eye where
 * that would get too coarse. Texels lie on a grid that stays in the world, and their size goes in steps, so that a
 * shadow's edge does not crawl while the thing beside it moves. One object serves frame after frame.
 */
public final class ThingSunMap {
    private static final double FINEST_TEXEL_METRES = 0.005;
    /** Shadows of bodies a portal leads to are seen as well: what is far from the eye must stay in for long. */
    private static final double COARSEST_TEXEL_METRES = 0.06;
    /** Empty texels around the casters, as the filter may ask for them. */
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
    /** Whether something was left out, for being far from {@link #fittedTo}. */
    private boolean isLimited;

    private Vec3 fittedTo = Vec3.ZERO;

    /** @param side texels that the map has along each side */
    public ThingSunMap(int side) {
        this.side = side;
    }

    /** The map of a sun elsewhere. @param newTowardsSun any length but zero */
    public void turn(Vec3 newTowardsSun) {
        towardsSun = newTowardsSun;
        back.set(towardsSun.toVector().normalize());
        right.set(Math.abs(back.y) < 0.999 ? new Vector3d(0, 1, 0).cross(back).normalize() : new Vector3d(1, 0, 0));
        right.fma(-right.dot(back), back).normalize();
        back.cross(right, up);
    }

    /** As it was last told; {@code null} before. */
    public Vec3 towardsSun() {
        return towardsSun;
    }

    /** Fits the map to all instances, or to those that a map of the coarsest texels around {@code eye} may hold. */
    public void fit(ThingCopies copies, Vec3 eye) {
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

    /** Whether the eye has gone so far that other things are near it now. */
    public boolean isOutgrown(Vec3 eye) {
        double metres = side * COARSEST_TEXEL_METRES / 16;
        return isLimited && eye.toVector().distanceSquared(fittedTo.x(), fittedTo.y(), fittedTo.z()) > metres * metres;
    }

    /** What casts, along the map's axes; nothing leaves an empty range. */
    private void bound(ThingCopies copies, Vec3 eye, double within) {
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

    /** Moves a range out to the grid. @return its texels */
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

    /** Texels along the rows that are in use; 0 where nothing casts. */
    public int width() {
        return width;
    }

    public int height() {
        return height;
    }

    public double texelMetres() {
        return texel;
    }

    /** What depth 0 to 1 spans; it grows away from the sun. */
    public double depthMetres() {
        return high[2] - low[2];
    }

    public Vector3d right() {
        return right;
    }

    public Vector3d up() {
        return up;
    }

    /** Metres relative to {@code anchor} to texture coordinates and depth, all 0 to 1. */
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
