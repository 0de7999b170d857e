package nephele.workshop.art.picture;

import java.awt.image.BufferedImage;
import nephele.workshop.art.paint.PaintColour;
import nephele.workshop.art.paint.Pixels;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.Surface;
import nephele.workshop.art.paint.Surface.Texel;
import nephele.workshop.art.paint.TileNoise;

/** Painters of a lighthouse, its rock and the sea around it. */
final class CoastPainters {
    private static final int TOWER_SIDE = 256;
    private static final PaintColour WHITE = PaintColour.of(0xF1EDE4);

    private CoastPainters() {}

    /** Paints whitewashed brick with rain marks; a material's tint colours the bands of a tower. */
    static BufferedImage whitewash() {
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
    static void rock(Surface surface) {
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
    static void sea(Surface surface) {
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
}
