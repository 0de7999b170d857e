package nephele.engine.scene.light;

/**
 * The lit share of a 2 × 2 texel footprint of a depth map for a plane receiver; the twin of {@code shadow-filter.glsl}.
 * Comparing each texel with the plane's depth at that texel, instead of at the receiver's point with a bias, is Isidoro's
 * receiver plane ("Shadow Mapping: GPU-based Tips and Techniques", GDC 2006), here from the exact normal.
 */
public final class ShadowFilter {
    private ShadowFilter() {}

    /** Depths 0–1 by column and row; outside the map everything is lit. */
    @FunctionalInterface
    public interface DepthMap {
        double depth(int column, int row);
    }

    /** Depth by which something must be nearer to the light before it shades. */
    public static double contactTolerance(double halfTexelDepth, double gradientX, double gradientY) {
        return halfTexelDepth + Math.min(Math.abs(gradientX) + Math.abs(gradientY), 4 * halfTexelDepth);
    }

    /**
     * @param x texels, centre of the first column at ½
     * @param gradientX change of the receiver's depth from column to column
     */
    public static double litShare(
            DepthMap map, double x, double y, double receiverDepth, double gradientX, double gradientY) {
        int column = (int) Math.floor(x - 0.5);
        int row = (int) Math.floor(y - 0.5);
        double fx = x - 0.5 - column;
        double fy = y - 0.5 - row;
        double share = 0;
        for (int corner = 0; corner < 4; corner++) {
            int i = corner & 1;
            int j = corner >> 1;
            double plane = Math.min(receiverDepth + gradientX * (i - fx) + gradientY * (j - fy), 1);
            double weight = (i == 0 ? 1 - fx : fx) * (j == 0 ? 1 - fy : fy);
            share += map.depth(column + i, row + j) >= plane ? weight : 0;
        }
        return share;
    }
}
