package nephele.workshop.art.sprite;

import java.awt.image.BufferedImage;
import java.util.List;
import nephele.workshop.art.paint.TileNoise;
import nephele.workshop.art.picture.PictureRecipe;

/** The recipes of the pictures that billboards of levels name. */
public final class SpritePictures {
    public static final List<PictureRecipe> ALL = List.of(
            new PictureRecipe("textures/sprites/cypress.png", TreePainters::cypress),
            new PictureRecipe("textures/sprites/pine.png", TreePainters::pine),
            new PictureRecipe("textures/sprites/olive.png", TreePainters::olive),
            new PictureRecipe("textures/sprites/bush.png", HerbPainters::bush),
            new PictureRecipe("textures/sprites/grass.png", HerbPainters::grass),
            new PictureRecipe("textures/sprites/lavender.png", HerbPainters::lavender),
            new PictureRecipe("textures/sprites/mist.png", AtlasPainters::mist),
            new PictureRecipe("textures/sprites/smoke.png", AtlasPainters::smoke),
            new PictureRecipe("textures/sprites/fire.png", AtlasPainters::fire),
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
}
