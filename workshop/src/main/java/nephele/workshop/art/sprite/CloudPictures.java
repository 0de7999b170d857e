package nephele.workshop.art.sprite;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.TileNoise;
import nephele.workshop.art.picture.PictureRecipe;

/** The recipes of the pictures that clouds of levels name; coverage maps and densities repeat with the picture. */
public final class CloudPictures {
    private static final int PAINTED_PIXELS = 256;
    /** Centres and radii of the lobes, as fractions of the picture. */
    private static final double[][] LOBES = {
        {0.5, 0.5, 0.24},
        {0.33, 0.55, 0.17},
        {0.68, 0.46, 0.18},
        {0.42, 0.36, 0.14},
        {0.6, 0.62, 0.15},
        {0.8, 0.54, 0.1},
        {0.2, 0.5, 0.09}
    };

    public static final List<PictureRecipe> ALL = List.of(
            new PictureRecipe("textures/clouds/streaks.png", () -> grey(512, CloudPictures::cirrus)),
            new PictureRecipe("textures/clouds/ripples.png", () -> grey(512, CloudPictures::ripples)),
            new PictureRecipe("textures/clouds/painted.png", CloudPictures::painted));

    private CloudPictures() {}

    /** @param tone a value of 0 to 1 at a place of the picture, which runs from 0 to 1 in both directions from the upper left */
    private static BufferedImage grey(int side, DoubleBinaryOperator tone) {
        var picture = new BufferedImage(side, side, BufferedImage.TYPE_BYTE_GRAY);
        for (int row = 0; row < side; row++) {
            for (int column = 0; column < side; column++) {
                double value = tone.applyAsDouble((column + 0.5) / side, (row + 0.5) / side);
                picture.getRaster().setSample(column, row, 0, code(value));
            }
        }
        return picture;
    }

    static int code(double value) {
        return (int) Math.round(255 * Math.max(0, Math.min(1, value)));
    }

    /** Returns the coverage of cirrus: bundles of filaments along x, which the wind has combed and bent. */
    private static double cirrus(double x, double y) {
        double bent = y + 0.05 * new TileNoise(401).cloud(x, y, 2, 2) + 0.012 * new TileNoise(409).cloud(x, y, 6, 3);
        double along = x + 0.03 * new TileNoise(419).cloud(x, y, 3, 2);
        double bundle = Shapes.ramp(-0.12, 0.5, new TileNoise(421).stretched(along, bent, 3, 9, 3));
        double strand = 0.5 + 0.9 * new TileNoise(431).stretched(along, bent, 3, 36, 3);
        double thread = 0.5 + 0.9 * new TileNoise(433).stretched(along, bent, 6, 130, 1);
        double hair = Math.max(0, 0.8 * strand + 0.5 * thread - 0.25);
        double veil = 0.1 * Shapes.ramp(-0.3, 0.6, new TileNoise(439).cloud(x, y, 2, 4));
        return veil + bundle * hair * (0.5 + 0.7 * hair);
    }

    /** Returns the density of a mackerel sky: small rounded heaps in rows, in patches. */
    private static double ripples(double x, double y) {
        double warpedX = x + 0.02 * new TileNoise(443).cloud(x, y, 4, 3);
        double warpedY = y + 0.02 * new TileNoise(449).cloud(x, y, 4, 3);
        double patch = Shapes.ramp(-0.25, 0.45, new TileNoise(457).cloud(x, y, 3, 4));
        double row = 0.5 + 0.5 * StrictMath.sin(2 * Math.PI * (9 * warpedX + 23 * warpedY));
        double heap = 1 - new TileNoise(461).cell(warpedX, warpedY, 34).nearest();
        return Shapes.ramp(0.42, 1.05, 0.45 * row + 0.6 * heap + 0.45 * patch - 0.25) * patch;
    }

    /** Paints one cloud with alpha: a heap with lobes, opaque in the middle, thin at its rim. */
    private static BufferedImage painted() {
        var picture = new BufferedImage(PAINTED_PIXELS, PAINTED_PIXELS, BufferedImage.TYPE_INT_ARGB);
        for (int row = 0; row < PAINTED_PIXELS; row++) {
            for (int column = 0; column < PAINTED_PIXELS; column++) {
                double alpha = paintedAlpha((column + 0.5) / PAINTED_PIXELS, (row + 0.5) / PAINTED_PIXELS);
                picture.setRGB(column, row, code(alpha) << 24 | 0xffffff);
            }
        }
        return picture;
    }

    private static double paintedAlpha(double x, double y) {
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
