package nephele.workshop.art.material;

import java.util.function.Consumer;
import nephele.workshop.art.paint.Surface;

/**
 * The painter of a tileable material.
 *
 * @param name of the files: {@code textures/NAME.png} and {@code textures/NAME-normal.png}
 * @param metres side of the square that the picture covers, a material's {@code textureMetres}
 */
public record TextureRecipe(String name, double metres, Consumer<Surface> painter) {
    public String colourFile() {
        return "textures/" + name + ".png";
    }

    public String normalFile() {
        return "textures/" + name + "-normal.png";
    }

    public Surface paint() {
        Surface surface = new Surface(metres);
        painter.accept(surface);
        return surface;
    }
}
