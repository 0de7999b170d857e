package nephele.workshop.art.picture;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.function.Consumer;
import nephele.workshop.art.paint.Surface;

/** The recipes of the XML sample scenes' pictures and of the texture-coordinate test picture. */
public final class ScenePictures {
    private static final double TILE_METRES = 2;

    public static final List<PictureRecipe> ALL = List.of(
            PictureRecipe.globe("sun", 256, new SunPainter()),
            PictureRecipe.globe("mercury", 256, RockyGlobes.mercury()),
            PictureRecipe.globe("venus", 256, CloudyGlobes.venus()),
            PictureRecipe.globe("earth", 512, new EarthPainter()),
            PictureRecipe.globe("moon", 256, RockyGlobes.moon()),
            PictureRecipe.globe("mars", 256, RockyGlobes.mars()),
            PictureRecipe.globe("jupiter", 512, CloudyGlobes.jupiter()),
            PictureRecipe.globe("io", 128, RockyGlobes.io()),
            PictureRecipe.globe("europa", 256, RockyGlobes.europa()),
            PictureRecipe.globe("saturn", 256, CloudyGlobes.saturn()),
            PictureRecipe.globe("uranus", 128, CloudyGlobes.uranus()),
            PictureRecipe.globe("neptune", 256, CloudyGlobes.neptune()),
            new PictureRecipe("textures/scenes/saturn-rings.png", CloudyGlobes::saturnRings),
            new PictureRecipe("textures/scenes/stars.png", StarPainter::paint),
            new PictureRecipe("textures/scenes/hull.png", HullPainter::paint),
            new PictureRecipe("textures/scenes/whitewash.png", CoastPainters::whitewash),
            new PictureRecipe("textures/scenes/rock.png", () -> tile(CoastPainters::rock)),
            new PictureRecipe("textures/scenes/sea.png", () -> tile(CoastPainters::sea)),
            new PictureRecipe(NumberedGrid.FILE, NumberedGrid::paint));

    private ScenePictures() {}

    private static BufferedImage tile(Consumer<Surface> painter) {
        Surface surface = new Surface(TILE_METRES);
        painter.accept(surface);
        return surface.colourPicture();
    }
}
