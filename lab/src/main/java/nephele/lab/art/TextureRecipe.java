package nephele.lab.art;

import java.util.function.Consumer;

/**
 * The painter of a tileable material.
 *
 * @param name of the files: {@code textures/NAME.png} and {@code textures/NAME-normal.png}
 * @param metres side of the square that the picture covers, a material's {@code textureMetres}
 */
record TextureRecipe(String name, double metres, Consumer<Surface> painter) {
    String colourFile() {
        return "textures/" + name + ".png";
    }

    String normalFile() {
        return "textures/" + name + "-normal.png";
    }

    Surface paint() {
        Surface surface = new Surface(metres);
        painter.accept(surface);
        return surface;
    }
}
