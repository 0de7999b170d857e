package nephele.workshop.art.sprite;

import java.awt.image.BufferedImage;
import java.util.List;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.TileNoise;
import nephele.workshop.art.picture.PictureRecipe;

/** The recipes of the pictures that billboards of levels name. */
public final class SpritePictures {
    private static final TileNoise COARSE = new TileNoise(151);
    private static final TileNoise FINE = new TileNoise(157);

    public static final List<PictureRecipe> ALL = List.of(
            new PictureRecipe("textures/sprites/cypress.png", TreePainters::cypress),
            new PictureRecipe("textures/sprites/pine.png", TreePainters::pine),
            new PictureRecipe("textures/sprites/olive.png", TreePainters::olive),
            new PictureRecipe("textures/sprites/bush.png", HerbPainters::bush),
            new PictureRecipe("textures/sprites/grass.png", HerbPainters::grass),
            new PictureRecipe("textures/sprites/lavender.png", HerbPainters::lavender),
            new PictureRecipe("textures/sprites/mist.png", SpritePictures::mist),
            new PictureRecipe("textures/sprites/smoke.png", SpritePictures::smoke),
            new PictureRecipe("textures/sprites/fire.png", SpritePictures::fire),
            new PictureRecipe("textures/sprites/patches.png", SpritePictures::patches),
            new PictureRecipe("textures/sprites/olive-on-black.bmp", () -> onBlack(TreePainters.olive())));

    private SpritePictures() {}

    /** Returns a picture of 24 bits with sharp edges before black, as the monograph on terrain has them. */
    private static BufferedImage onBlack(BufferedImage painted) {
        var picture = new BufferedImage(painted.getWidth(), painted.getHeight(), BufferedImage.TYPE_3BYTE_BGR);
        for (int row = 0; row < painted.getHeight(); row++) {
            for (int column = 0; column < painted.getWidth(); column++) {
                int argb = painted.getRGB(column, row);
                picture.setRGB(column, row, argb >>> 24 >= 128 ? argb & 0xffffff : 0);
            }
        }
        return picture;
    }

    /** Returns a map of densities: patches with soft borders. */
    private static BufferedImage patches() {
        var picture = new BufferedImage(128, 128, BufferedImage.TYPE_BYTE_GRAY);
        TileNoise noise = new TileNoise(173);
        for (int row = 0; row < 128; row++) {
            for (int column = 0; column < 128; column++) {
                double value = 0.5 + 1.4 * noise.cloud((column + 0.5) / 128, (row + 0.5) / 128, 4, 4);
                picture.getRaster().setSample(column, row, 0, (int) Math.round(255 * Math.max(0, Math.min(1, value))));
            }
        }
        return picture;
    }

    /** A colour and its alpha at a place of a frame; y from the lower edge up. */
    private interface Frame {
        int argb(double x, double y, double turn);
    }

    private static BufferedImage row(int frames, int width, int height, Frame frame) {
        var picture = new BufferedImage(frames * width, height, BufferedImage.TYPE_INT_ARGB);
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < frames * width; column++) {
                double x = (column % width + 0.5) / width;
                double y = 1 - (row + 0.5) / height;
                picture.setRGB(column, row, frame.argb(x, y, (double) (column / width) / frames));
            }
        }
        return picture;
    }

    private static int argb(double alpha, double red, double green, double blue) {
        int a = code(alpha);
        return a == 0 ? 0 : a << 24 | code(red) << 16 | code(green) << 8 | code(blue);
    }

    private static int code(double value) {
        return (int) Math.round(255 * Math.max(0, Math.min(1, value)));
    }

    /** Returns 1 in the middle and 0 at all sides. */
    private static double window(double x, double y) {
        double dx = 2 * x - 1;
        double dy = 2 * y - 1;
        return Math.max(0, 1 - dx * dx) * Math.max(0, 1 - dy * dy);
    }

    private static BufferedImage mist() {
        return row(8, 192, 96, (x, y, turn) -> {
            double drift = COARSE.cloud(0.5 * x + turn, 0.4 * y, 4, 4);
            double veil = FINE.cloud(0.5 * x - turn, 0.3 * y + 0.3, 3, 4);
            double body = window(x, y) * (0.75 + 0.7 * drift + 0.5 * veil);
            double low = Shapes.ramp(1.0, 0.1, y);
            double alpha = 0.62 * Shapes.ramp(0.12, 0.9, body) * (0.4 + 0.6 * low);
            double grey = 0.93 + 0.05 * drift;
            return argb(alpha, grey, grey, Math.min(1, grey + 0.02));
        });
    }

    /** A column that widens upwards and dissolves. */
    private static BufferedImage smoke() {
        return row(16, 128, 192, (x, y, turn) -> {
            double sway = 0.10 * y * COARSE.cloud(0.13, 0.35 * y - turn, 3, 2);
            double half = 0.1 + 0.3 * Math.sqrt(y);
            double across = (x - 0.5 - sway) / half;
            double billow = COARSE.cloud(0.6 * x, 0.5 * y - turn, 5, 5);
            double curl = FINE.cell(0.5 * x + 0.05 * billow, 0.5 * y - turn, 9).nearest();
            double body = 1 - across * across + 0.85 * billow - 0.35 * curl;
            double ends = Shapes.ramp(0, 0.1, y) * Shapes.ramp(1, 0.55, y) * Shapes.ramp(0, 0.12, Math.min(x, 1 - x));
            double alpha = 0.88 * ends * Shapes.ramp(0.1, 0.95, body);
            double grey = 0.34 + 0.22 * y + 0.14 * billow - 0.1 * curl;
            return argb(alpha, grey, grey * 0.985, grey * 0.96);
        });
    }

    /** Tongues that rise, white in the middle below and red at their tips. */
    private static BufferedImage fire() {
        return row(16, 128, 192, (x, y, turn) -> {
            double sway = 0.13 * y * FINE.cloud(0.37, 0.4 * y - turn, 4, 3);
            double across =
                    (x - 0.5 - sway) / (0.36 * Math.sqrt(Math.max(0, 1 - y)) * Shapes.ramp(-0.06, 0.16, y) + 0.02);
            double tongues = COARSE.stretched(0.9 * x, 0.45 * y - turn, 7, 4, 4);
            double licks = FINE.stretched(1.1 * x, 0.5 * y - turn, 11, 6, 3);
            double heat = 1.15 - across * across - 0.75 * y + (0.35 + 0.9 * y) * tongues + 0.45 * y * licks;
            double rim = Shapes.ramp(0, 0.08, Math.min(x, 1 - x)) * Shapes.ramp(1, 0.86, y) * Shapes.ramp(0, 0.05, y);
            double alpha = rim * Shapes.ramp(0.05, 0.42, heat);
            double hot = Shapes.ramp(0.15, 1.15, heat);
            return argb(
                    alpha, 0.85 + 0.15 * hot, 0.16 + 0.72 * StrictMath.pow(hot, 1.15), 0.02 + 0.5 * hot * hot * hot);
        });
    }
}
