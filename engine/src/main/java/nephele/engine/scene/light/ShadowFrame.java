package nephele.engine.scene.light;

import java.util.List;
import nephele.engine.math.Vec3;
import org.joml.Matrix4d;
import org.joml.Vector3d;

/**
 * The parallel projection of a sun's depth map, fitted to the shadow casters.
 *
 * @param anchor world position that float coordinates in shaders are relative to
 * @param mapFromAnchor metres relative to the anchor → texture coordinates and depth, all 0–1; depth grows away from
 *     the sun
 * @param right unit axis along the map's rows, {@code up} along its columns
 * @param width texels, {@code height} likewise
 * @param texelMetres side of a texel, the same along both axes
 * @param depthMetres distance spanned by depth 0–1
 */
public record ShadowFrame(
        Vec3 anchor,
        Matrix4d mapFromAnchor,
        Vec3 right,
        Vec3 up,
        int width,
        int height,
        double texelMetres,
        double depthMetres) {
    /** Smaller texels are indistinguishable from a distance of 3 m at 1280 × 720. */
    public static final double FINEST_TEXEL_METRES = 0.01;

    /**
     * Texels at the map's border in which nothing is drawn. A lookup outside the map reads the nearest of them, which must
     * not show a ground that reaches out of the map: that ground is elsewhere nearer to the sun or farther away.
     */
    public static final int BORDER_TEXELS = 1;

    /** Texels between the casters and the map's side: a filter within the border reads lit ones. */
    private static final int MARGIN_TEXELS = BORDER_TEXELS + 2;

    /**
     * Fits a projection whose longer side is the width. The width of a large map is then {@code maxSide} whatever is
     * edited; llvmpipe compiles every shader that reads a map anew if a side becomes or ceases to be a power of two.
     *
     * @param casters corners of all shadow casters
     * @param towardsSun any length but zero
     * @param maxSide texels; a map never has fewer than its margins and one
     */
    public static ShadowFrame fit(List<Vec3> casters, Vec3 towardsSun, Vec3 anchor, int maxSide) {
        Vector3d back = towardsSun.toVector().normalize();
        Vector3d right =
                Math.abs(back.y) < 0.999 ? new Vector3d(0, 1, 0).cross(back).normalize() : new Vector3d(1, 0, 0);
        right.fma(-right.dot(back), back).normalize();
        Vector3d up = new Vector3d(back).cross(right);
        double[] x = range(casters, anchor, right);
        double[] y = range(casters, anchor, up);
        if (y[1] - y[0] > x[1] - x[0]) {
            Vector3d left = new Vector3d(right).negate();
            right = up;
            up = left;
            x = y;
            y = range(casters, anchor, up);
        }
        double[] z = range(casters, anchor, back);
        double texel = Math.max(FINEST_TEXEL_METRES, (x[1] - x[0]) / Math.max(1, maxSide - 2 * MARGIN_TEXELS));
        int width = texels(x, texel);
        int height = texels(y, texel);
        double depth = (z[1] - z[0]) * 1.01 + 0.1;
        Matrix4d map = rows(
                new Vector3d(right).div(width * texel), 0.5 - (x[0] + x[1]) / 2 / (width * texel),
                new Vector3d(up).div(height * texel), 0.5 - (y[0] + y[1]) / 2 / (height * texel),
                new Vector3d(back).div(-depth), 0.5 + (z[0] + z[1]) / 2 / depth);
        return new ShadowFrame(anchor, map, value(right), value(up), width, height, texel, depth);
    }

    private static Vec3 value(Vector3d v) {
        return new Vec3(v.x, v.y, v.z);
    }

    private static double[] range(List<Vec3> points, Vec3 anchor, Vector3d axis) {
        double min = Double.POSITIVE_INFINITY;
        double max = Double.NEGATIVE_INFINITY;
        for (Vec3 p : points) {
            double along = axis.dot(p.x() - anchor.x(), p.y() - anchor.y(), p.z() - anchor.z());
            min = Math.min(min, along);
            max = Math.max(max, along);
        }
        return new double[] {min, max};
    }

    private static int texels(double[] range, double texel) {
        return (int) Math.ceil((range[1] - range[0]) / texel - 1e-9) + 2 * MARGIN_TEXELS;
    }

    private static Matrix4d rows(Vector3d x, double x3, Vector3d y, double y3, Vector3d z, double z3) {
        return new Matrix4d(x.x, y.x, z.x, 0, x.y, y.y, z.y, 0, x.z, y.z, z.z, 0, x3, y3, z3, 1);
    }

    /** Returns the projection for drawing the map: coordinates and depth −1 to 1. */
    public Matrix4d clipFromAnchor() {
        return new Matrix4d().translation(-1, -1, -1).scale(2).mul(mapFromAnchor);
    }
}
