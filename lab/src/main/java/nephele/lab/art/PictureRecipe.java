package nephele.lab.art;

import java.awt.image.BufferedImage;
import java.util.function.Supplier;

/** How a picture that is no tileable material is painted. @param file asset id */
record PictureRecipe(String file, Supplier<BufferedImage> painter) {
    static PictureRecipe globe(String name, int height, Globe.Brush brush) {
        return new PictureRecipe("textures/scenes/" + name + ".png", () -> Globe.paint(height, brush));
    }
}
