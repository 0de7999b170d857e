package nephele.workshop.art.picture;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.function.Consumer;
import nephele.workshop.art.paint.PaintColour;
import nephele.workshop.art.paint.Pixels;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.Surface;
import nephele.workshop.art.paint.Surface.Texel;
import nephele.workshop.art.paint.TileNoise;

/**
 * The recipes of the XML sample scenes' pictures and of the texture-coordinate test picture, and the painters of a
 * lighthouse, its rock, the sea around it and a ship's hull.
 */
public final class ScenePictures {
    private static final double TILE_METRES = 2;
    private static final int TOWER_SIDE = 256;
    private static final PaintColour WHITE = PaintColour.of(0xF1EDE4);
    private static final int HULL_SIDE = 512;
    private static final PaintColour PLATE = PaintColour.of(0xD9DCE0);
    private static final PaintColour DARK_PLATE = PaintColour.of(0x9AA3AD);
    private static final PaintColour SEAM = PaintColour.of(0x3E454E);
    private static final PaintColour STRIPE = PaintColour.SIGNAL;

    public static final List<PictureRecipe> ALL = List.of(
            PictureRecipe.globe("sun", 256, CloudyGlobes.sun()),
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
            new PictureRecipe("textures/scenes/hull.png", ScenePictures::hull),
            new PictureRecipe("textures/scenes/whitewash.png", ScenePictures::whitewash),
            new PictureRecipe("textures/scenes/rock.png", () -> tile(ScenePictures::rock)),
            new PictureRecipe("textures/scenes/sea.png", () -> tile(ScenePictures::sea)),
            new PictureRecipe(NumberedGrid.FILE, NumberedGrid::paint));

    private ScenePictures() {}

    private static BufferedImage tile(Consumer<Surface> painter) {
        Surface surface = new Surface(TILE_METRES);
        painter.accept(surface);
        return surface.colourPicture();
    }

    /** Paints whitewashed brick with rain marks; a material's tint colours the bands of a tower. */
    private static BufferedImage whitewash() {
        TileNoise noise = new TileNoise(961);
        return Pixels.picture(TOWER_SIDE, TOWER_SIDE, (column, row) -> brick(
                        noise, (column + 0.5) / TOWER_SIDE, 1 - (row + 0.5) / TOWER_SIDE)
                .rgb());
    }

    private static PaintColour brick(TileNoise noise, double u, double v) {
        double course = v * 10;
        double brick = u * 28 + ((int) course % 2 == 0 ? 0.5 : 0);
        double joint = Math.max(
                Shapes.line(course - Math.rint(course), 0.07, 0.06), Shapes.line(brick - Math.rint(brick), 0.05, 0.04));
        double rain = Math.max(0, noise.stretched(u, v, 40, 3, 3));
        return WHITE.times(1 + 0.05 * noise.cloud(u, v, 6, 5) - 0.12 * rain - 0.14 * joint);
    }

    /** Paints dark stone in folded layers, with cracks. */
    private static void rock(Surface surface) {
        TileNoise noise = new TileNoise(967);
        surface.each((x, y, texel) -> {
            double u = x / surface.metres();
            double v = y / surface.metres();
            double bend = 0.06 * noise.cloud(u, v, 3, 4);
            double layers = noise.stretched(u + bend, v + bend, 3, 14, 4);
            double lump = noise.cloud(u, v, 5, 6);
            TileNoise.Cell cell = noise.cell(u + 0.5 * bend, v - 0.5 * bend, 7);
            double crack = 1 - Shapes.ramp(0.01, 0.05, cell.second() - cell.nearest());
            texel.colour = PaintColour.of(0x6C6660).mix(PaintColour.of(0x8D8373), 0.5 + 0.5 * layers);
            texel.shade((0.95 + 0.25 * lump + 0.12 * (cell.identity() - 0.5)) * (1 - 0.5 * crack));
            lichen(texel, noise.cloud(u + 0.3, v + 0.7, 6, 5));
            texel.height = 0.03 * lump + 0.01 * layers - 0.02 * crack;
            texel.roughness = 1;
        });
    }

    private static void lichen(Texel texel, double patch) {
        texel.blend(PaintColour.of(0x9A9450), 0.5 * Shapes.ramp(0.3, 0.5, patch));
    }

    /** Paints open water seen from above: swell, ripples and a little foam. */
    private static void sea(Surface surface) {
        TileNoise noise = new TileNoise(971);
        surface.each((x, y, texel) -> {
            double u = x / surface.metres();
            double v = y / surface.metres();
            double bend = 0.03 * noise.cloud(u, v, 4, 3);
            double swell = noise.stretched(u + bend, v, 4, 9, 4);
            double ripple = noise.stretched(u - bend, v + bend, 18, 34, 3);
            double crest = Shapes.ramp(0.45, 0.75, 0.75 * swell + 0.4 * ripple);
            texel.colour = PaintColour.of(0x0F3A4D).mix(PaintColour.of(0x2B6F80), 0.5 + 0.55 * swell + 0.2 * ripple);
            texel.blend(PaintColour.of(0xDDEDEB), 0.55 * crest * Shapes.ramp(0, 0.4, noise.cloud(u, v, 40, 2)));
            texel.height = 0.05 * swell + 0.01 * ripple;
            texel.roughness = 0.4;
        });
    }

    /** Paints a small ship's hull: pale panels of several sizes, seams, hatches, a signal stripe and wear. */
    private static BufferedImage hull() {
        TileNoise noise = new TileNoise(931);
        return Pixels.picture(HULL_SIDE, HULL_SIDE, (column, row) -> hull(
                        noise, (column + 0.5) / HULL_SIDE, 1 - (row + 0.5) / HULL_SIDE)
                .rgb());
    }

    private static PaintColour hull(TileNoise noise, double u, double v) {
        int cells = TileNoise.random((int) (u * 4), (int) (v * 4), 937) < 0.45 ? 4 : 8;
        int column = (int) (u * cells);
        int row = (int) (v * cells);
        double tone = TileNoise.random(column, row, 941 + cells);
        PaintColour plate = tone > 0.8 ? DARK_PLATE : PLATE.times(0.93 + 0.1 * tone);
        double inX = Math.abs(u * cells - column - 0.5);
        double inY = Math.abs(v * cells - row - 0.5);
        double edge = (0.5 - Math.max(inX, inY)) / cells;
        double stripe = Shapes.line(v - 0.5, 0.035, 0.004) + 0.8 * Shapes.line(v - 0.56, 0.008, 0.004);
        PaintColour painted = plate.mix(STRIPE, Math.min(1, stripe) * (0.86 + 0.1 * noise.cloud(u, v, 12, 3)));
        double bolt = Shapes.disc(0.42 - inX, 0.42 - inY, 0.025, 0.02) * (cells == 4 ? 1 : 0);
        double hatch = Shapes.line(Shapes.roundedBox(inX, inY, 0.22, 0.22, 0.06), 0.012, 0.012) * (tone < 0.12 ? 1 : 0);
        double seam = 1 - Shapes.ramp(0.001, 0.0035, edge);
        double wear = 0.03 * noise.cloud(u, v, 5, 5) + 0.03 * noise.stretched(u, v, 6, 60, 3);
        return painted.times(1 + wear).mix(SEAM, 0.75 * Math.max(seam, Math.max(0.6 * bolt, 0.7 * hatch)));
    }
}
