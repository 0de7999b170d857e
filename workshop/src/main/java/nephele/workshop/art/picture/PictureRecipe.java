package nephele.workshop.art.picture;

import java.awt.image.BufferedImage;
import java.util.function.Supplier;

/**
 * The painter of a picture that is not a tileable material.
 *
 * @param file asset id
 */
public record PictureRecipe(String file, Supplier<BufferedImage> painter) {
    static PictureRecipe globe(String name, int height, Globe.Brush brush) {
        return new PictureRecipe("textures/scenes/" + name + ".png", () -> Globe.paint(height, brush));
    }
}
