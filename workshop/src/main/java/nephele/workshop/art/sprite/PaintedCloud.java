package nephele.workshop.art.sprite;

import java.awt.image.BufferedImage;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.TileNoise;

/** Painter of one cloud as a picture with alpha: a heap with lobes, opaque in the middle, thin at its rim. */
final class PaintedCloud {
    private static final int SIDE_PIXELS = 256;

    /** Centres and radii of the lobes, in shares of the picture. */
    private static final double[][] LOBES = {
        {0.5, 0.5, 0.24},
        {0.33, 0.55, 0.17},
        {0.68, 0.46, 0.18},
        {0.42, 0.36, 0.14},
        {0.6, 0.62, 0.15},
        {0.8, 0.54, 0.1},
        {0.2, 0.5, 0.09}
    };

    private PaintedCloud() {}

    static BufferedImage paint() {
        var picture = new BufferedImage(SIDE_PIXELS, SIDE_PIXELS, BufferedImage.TYPE_INT_ARGB);
        for (int row = 0; row < SIDE_PIXELS; row++) {
            for (int column = 0; column < SIDE_PIXELS; column++) {
                double alpha = alpha((column + 0.5) / SIDE_PIXELS, (row + 0.5) / SIDE_PIXELS);
                picture.setRGB(column, row, CloudPictures.code(alpha) << 24 | 0xffffff);
            }
        }
        return picture;
    }

    private static double alpha(double x, double y) {
        double bumps = 0.05 * new TileNoise(463).cloud(x, y, 6, 5);
        double billows = 0.05 * (0.6 - new TileNoise(467).cell(x, y, 12).nearest());
        double inside = -1;
        for (double[] lobe : LOBES) {
            double dx = x - lobe[0];
            double dy = y - lobe[1];
            inside = Math.max(inside, lobe[2] - Math.sqrt(dx * dx + dy * dy));
        }
        double depth = inside + bumps + billows;
        double rim = Shapes.ramp(0, 0.01, Math.min(Math.min(x, 1 - x), Math.min(y, 1 - y)));
        return rim * (0.75 * Shapes.ramp(-0.01, 0.07, depth) + 0.25 * Shapes.ramp(0.04, 0.16, depth));
    }
}
