package nephele.workshop.art.material;

import nephele.workshop.art.paint.Bond;
import nephele.workshop.art.paint.PaintColour;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.Surface;
import nephele.workshop.art.paint.Surface.Texel;
import nephele.workshop.art.paint.TileNoise;

/** Painters of warm oak: planks for floors and doors, slats for walls. */
final class WoodPainters {
    private WoodPainters() {}

    /** Paints planks of 2 × 0.2 m that run to the right, each row shifted by 0.37 of a plank. */
    static void planks(Surface surface) {
        Bond planks = new Bond(surface.metres(), 1, 10, 0.37);
        surface.each((x, y, texel) -> {
            Bond.Piece plank = planks.at(x, y);
            grain(surface.metres(), x, y, plank.row(), texel);
            texel.shade(0.94 + 0.14 * (plank.random(3) - 0.5));
            joint(plank, texel);
        });
    }

    private static void joint(Bond.Piece plank, Texel texel) {
        double open = 1 - Shapes.ramp(0.001, 0.006, plank.edge());
        texel.blend(PaintColour.CHARCOAL, 0.7 * open);
        texel.height -= 0.004 * open;
    }

    /** Paints fibres along x; the grain of each board is different. */
    private static void grain(double metres, double x, double y, int board, Texel texel) {
        TileNoise noise = new TileNoise(131 + 17 * board);
        double u = x / metres;
        double v = y / metres;
        double sway = noise.stretched(u, v, 2, 6, 3);
        double rings = 0.5 + 0.5 * StrictMath.sin(2 * Math.PI * (9 * v * 4 + 3.2 * sway));
        double fibre = noise.stretched(u, v, 6, 150, 2);
        double pore = Shapes.ramp(0.35, 0.8, noise.stretched(u, v, 12, 220, 1));
        texel.colour =
                PaintColour.OAK.mix(PaintColour.OAK_DARK, 0.3 * rings * rings + 0.1 * Shapes.ramp(-0.5, 1, sway));
        texel.shade(1 + 0.06 * fibre - 0.14 * pore);
        texel.height = 0.0002 * fibre - 0.0003 * pore;
        texel.roughness = 0.85 + 0.1 * rings;
    }

    /** Paints upright slats, 75 mm wide every 100 mm, in front of dark felt. */
    static void slats(Surface surface) {
        Bond slats = new Bond(surface.metres(), 20, 1, 0);
        surface.each((x, y, texel) -> {
            Bond.Piece slat = slats.at(x, y);
            double face = 1 - Shapes.ramp(0.034, 0.040, Math.abs(slat.x()));
            grain(surface.metres(), y, x, slat.column(), texel);
            texel.shade(0.95 + 0.16 * (slat.random(5) - 0.5));
            double shadow = Shapes.ramp(0.036, 0.05, Math.abs(slat.x()));
            PaintColour felt = PaintColour.CHARCOAL.times(0.75 - 0.25 * (1 - shadow));
            texel.colour = felt.mix(texel.colour, face);
            texel.height = texel.height * face + 0.012 * face;
            texel.roughness = face * texel.roughness + (1 - face);
        });
    }
}
