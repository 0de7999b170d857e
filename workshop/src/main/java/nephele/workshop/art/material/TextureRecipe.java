package nephele.workshop.art.material;

import java.util.List;
import java.util.function.Consumer;
import nephele.workshop.art.paint.Surface;

/**
 * The painter of a tileable material.
 *
 * @param name of the files: {@code textures/NAME.png} and {@code textures/NAME-normal.png}
 * @param metres side of the square that the picture covers, a material's {@code textureMetres}
 */
public record TextureRecipe(String name, double metres, Consumer<Surface> painter) {
    /** The recipes of every tileable material of the game; levels name the files. */
    public static final List<TextureRecipe> ALL = List.of(
            new TextureRecipe("concrete", 2, GroundPainters::concrete),
            new TextureRecipe("plaster", 2, GroundPainters::plaster),
            new TextureRecipe("paver", 2, GroundPainters::paver),
            new TextureRecipe("terrazzo", 2, GroundPainters::terrazzo),
            new TextureRecipe("gravel", 2, GroundPainters::gravel),
            new TextureRecipe("brick", 2, CeramicPainters::brick),
            new TextureRecipe("terracotta", 2, CeramicPainters::terracotta),
            new TextureRecipe("mosaic", 2, CeramicPainters::mosaic),
            new TextureRecipe("water", 2, CeramicPainters::water),
            new TextureRecipe("wood-planks", 2, WoodPainters::planks),
            new TextureRecipe("wood-slats", 2, WoodPainters::slats),
            new TextureRecipe("panel-white", 2, PanelPainters::white),
            new TextureRecipe("panel-ceiling", 2, PanelPainters::ceiling),
            new TextureRecipe("panel-lamp", 1, PanelPainters::light),
            new TextureRecipe("glass", 2, PanelPainters::glass),
            new TextureRecipe("metal-plates", 2, MetalPainters::plates),
            new TextureRecipe("metal-frame", 2, MetalPainters::frame),
            new TextureRecipe("hazard", 1, MetalPainters::hazard),
            new TextureRecipe("grass", 2, GroundPainters::lawn),
            new TextureRecipe("cliff", 4, GroundPainters::cliff));

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
