package nephele.engine.scene.light;

import nephele.engine.math.Vec3;

/**
 * The lit share of a 2 × 2 texel footprint of a depth map for a planar receiver; the twin of
 * {@code shadow-filter.glsl}. Comparing each texel with the plane's depth at that texel, instead of at the receiver's
 * point with a bias, is Isidoro's receiver plane ("Shadow Mapping: GPU-based Tips and Techniques", GDC 2006), here from
 * the exact normal. Depth grows away from the light.
 */
public final class ShadowFilter {
    /** The bits of a stored depth that contain the octant of the face's normal. */
    private static final int OCTANT = 7;

    private ShadowFilter() {}

    /**
     * The four texels around a position.
     *
     * @param dx from the position to their centres, texels, in the order of {@code textureGather}: upper left, upper
     *     right, lower right, lower left
     * @param dy likewise
     * @param weight bilinear weights
     */
    public record Footprint(double[] dx, double[] dy, double[] weight) {
        /**
         * Returns the footprint of a position.
         *
         * @param x texels, centre of the first column at ½
         */
        public static Footprint at(double x, double y) {
            double fx = x - 0.5 - Math.floor(x - 0.5);
            double fy = y - 0.5 - Math.floor(y - 0.5);
            double[] dx = {-fx, 1 - fx, 1 - fx, -fx};
            double[] dy = {1 - fy, 1 - fy, -fy, -fy};
            double[] weight = new double[4];
            for (int i = 0; i < 4; i++) {
                weight[i] = (1 - Math.abs(dx[i])) * (1 - Math.abs(dy[i]));
            }
            return new Footprint(dx, dy, weight);
        }
    }

    /**
     * Returns the depth by which each texel is nearer to the light than a plane; an empty one, of depth 1, is never nearer.
     *
     * @param gradientX change of the plane's depth per column
     */
    public static double[] nearerThanPlane(
            double[] depths, double planeDepth, double gradientX, double gradientY, Footprint four) {
        double[] nearerBy = new double[4];
        for (int i = 0; i < 4; i++) {
            double plane = planeDepth + gradientX * four.dx()[i] + gradientY * four.dy()[i];
            nearerBy[i] = depths[i] < 1 ? plane - depths[i] : Math.min(plane - depths[i], 0);
        }
        return nearerBy;
    }

    /**
     * Same for depth as distance over range; in the picture of a plane 1 / distance is linear.
     *
     * @param gradientX change of 1 / distance per column
     */
    public static double[] nearerThanPlaneOfLight(
            double[] depths, double distance, double gradientX, double gradientY, double range, Footprint four) {
        double[] nearerBy = new double[4];
        for (int i = 0; i < 4; i++) {
            double perDistance = 1 / distance + gradientX * four.dx()[i] + gradientY * four.dy()[i];
            nearerBy[i] = 1 / Math.max(perDistance * range, 1) - depths[i];
        }
        return nearerBy;
    }

    /**
     * Returns the lit share, 0 to 1.
     *
     * @param nearerBy depth by which each texel is nearer to the light than the receiver's plane
     * @param halfTexelDepth half a texel's side in units of depth
     * @param slope change of the plane's depth per texel, both axes together
     */
    public static double litShare(double[] nearerBy, double[] weight, double halfTexelDepth, double slope) {
        double tolerance = halfTexelDepth + Math.min(slope, 4 * halfTexelDepth);
        double lit = 0;
        for (int i = 0; i < 4; i++) {
            lit += nearerBy[i] <= tolerance ? weight[i] : 0;
        }
        return lit;
    }

    /**
     * Same as {@link #litShare}, for a receiver that is itself in the map.
     *
     * @param isLike true for the texels that may show the receiver
     */
    public static double litShareOfMapped(
            double[] nearerBy, boolean[] isLike, double[] weight, double halfTexelDepth, double slope) {
        double rounding = 0.125 * halfTexelDepth + Math.min(slope / 64, 2 * halfTexelDepth);
        double shading = 5 * halfTexelDepth + 2 * slope;
        double lit = 0;
        double shaded = 0;
        double nearer = 0;
        for (int i = 0; i < 4; i++) {
            nearer += nearerBy[i] >= rounding ? weight[i] : 0;
            lit += isLike[i] && nearerBy[i] >= -rounding && nearerBy[i] < rounding ? weight[i] : 0;
            shaded += nearerBy[i] >= shading ? weight[i] : 0;
        }
        if (lit > 0) {
            return lit / (lit + shaded + Math.max(0.15 - lit, 0) * (nearer - shaded));
        }
        return nearer > 0 ? 0 : 1;
    }

    /** Returns the same as {@link #litShare} for the one texel that contains the position. */
    public static boolean litByNearest(double nearerBy, double halfTexelDepth, double slope) {
        return nearerBy <= halfTexelDepth + Math.min(slope, 4 * halfTexelDepth);
    }

    /**
     * Returns the same as {@link #litShareOfMapped} for one texel; a texel that shows another face shades only if that
     * face cannot be at a joint.
     */
    public static boolean litByNearestOfMapped(double nearerBy, boolean isLike, double halfTexelDepth, double slope) {
        double rounding = 0.125 * halfTexelDepth + Math.min(slope / 64, 2 * halfTexelDepth);
        return nearerBy < (isLike ? rounding : 5 * halfTexelDepth + 2 * slope);
    }

    /** Returns a code for the direction of a face, 0–7; it differs for the six faces of an axis-aligned box. */
    public static int octantOf(Vec3 normal) {
        double first = 0.8971 * normal.x() + 0.8113 * normal.y() + 0.7019 * normal.z();
        double second = 0.7907 * normal.x() - 0.9043 * normal.y() + 0.6133 * normal.z();
        double third = 0.6803 * normal.x() + 0.5941 * normal.y() - 0.9187 * normal.z();
        return (first > 0 ? 1 : 0) | (second > 0 ? 2 : 0) | (third > 0 ? 4 : 0);
    }

    /** Returns the value stored in a map of static geometry. */
    public static float depthWithOctant(float depth, int octant) {
        return Float.intBitsToFloat(Float.floatToRawIntBits(depth) & ~OCTANT | octant);
    }

    /** Returns true if a texel of such a map may show a face with this octant. */
    public static boolean looksLike(float depth, int octant) {
        return (Float.floatToRawIntBits(depth) & OCTANT) == octant || depth >= 1;
    }
}
