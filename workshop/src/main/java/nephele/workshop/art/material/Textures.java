package nephele.workshop.art.material;

import java.util.List;

/** The recipes of every tileable material of the game; levels name the files. */
public final class Textures {
    public static final List<TextureRecipe> ALL = List.of(
            new TextureRecipe("concrete", 2, StonePainters::concrete),
            new TextureRecipe("plaster", 2, StonePainters::plaster),
            new TextureRecipe("paver", 2, StonePainters::paver),
            new TextureRecipe("terrazzo", 2, StonePainters::terrazzo),
            new TextureRecipe("gravel", 2, StonePainters::gravel),
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
            new TextureRecipe("grass", 2, GrassPainter::lawn),
            new TextureRecipe("cliff", 4, CliffPainter::cliff));

    private Textures() {}
}
