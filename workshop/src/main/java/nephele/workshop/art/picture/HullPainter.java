package nephele.workshop.art.picture;

import java.awt.image.BufferedImage;
import nephele.workshop.art.paint.PaintColour;
import nephele.workshop.art.paint.Pixels;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.TileNoise;

/** Painter of a small ship's hull: pale panels of several sizes, seams, hatches, a signal stripe and wear. */
final class HullPainter {
    private static final int SIDE = 512;
    private static final PaintColour PLATE = PaintColour.of(0xD9DCE0);
    private static final PaintColour DARK_PLATE = PaintColour.of(0x9AA3AD);
    private static final PaintColour SEAM = PaintColour.of(0x3E454E);
    private static final PaintColour STRIPE = PaintColour.SIGNAL;

    private HullPainter() {}

    static BufferedImage paint() {
        TileNoise noise = new TileNoise(931);
        return Pixels.picture(SIDE, SIDE, (column, row) -> colour(noise, (column + 0.5) / SIDE, 1 - (row + 0.5) / SIDE)
                .rgb());
    }

    private static PaintColour colour(TileNoise noise, double u, double v) {
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
