package nephele.workshop.art.material;

import nephele.workshop.art.paint.Bond;
import nephele.workshop.art.paint.PaintColour;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.Surface;
import nephele.workshop.art.paint.Surface.Texel;
import nephele.workshop.art.paint.TileNoise;

/** Painters of ceramics: brick, terracotta tile, mosaic, and the mosaic under water. */
final class CeramicPainters {
    private static final int TESSERAE = 32;

    private CeramicPainters() {}

    /** Paints thin sand-coloured bricks in running bond with flush pale mortar. */
    static void brick(Surface surface) {
        Bond bricks = new Bond(surface.metres(), 8, 24, 0.5);
        TileNoise noise = new TileNoise(71);
        surface.each((x, y, texel) -> {
            double u = x / surface.metres();
            double v = y / surface.metres();
            double wobble = 0.002 * noise.cloud(u, v, 24, 2);
            Bond.Piece brick = bricks.at(x, y);
            double body = Shapes.ramp(0.004, 0.011, brick.edge() + wobble);
            double grain = noise.cloud(u, v, 72, 2);
            double patch = noise.cloud(u, v, 10, 4);
            PaintColour clay = PaintColour.BRICK.mix(PaintColour.TERRACOTTA, 0.55 * brick.random(4) * brick.random(9));
            clay = clay.mix(PaintColour.MORTAR, 0.16 * Shapes.ramp(0, 0.8, patch));
            texel.colour = PaintColour.MORTAR.times(0.93 + 0.03 * grain);
            texel.blend(clay.times(0.95 + 0.13 * (brick.random(5) - 0.5) + 0.05 * grain), body);
            texel.height = 0.005 * body + 0.0008 * grain * body + 0.0016 * (brick.random(6) - 0.5) * body;
            texel.roughness = 1 - 0.08 * body * brick.random(7);
        });
    }

    /** Paints hand-made square tiles, 0.25 m wide. */
    static void terracotta(Surface surface) {
        Bond tiles = new Bond(surface.metres(), 8, 8, 0);
        TileNoise noise = new TileNoise(83);
        surface.each((x, y, texel) -> {
            double u = x / surface.metres();
            double v = y / surface.metres();
            Bond.Piece tile = tiles.at(x, y);
            double wobble = 0.0025 * noise.cloud(u, v, 18, 2);
            double body = Shapes.ramp(0.003, 0.009, tile.edge() + wobble);
            double cloudy = noise.cloud(u + tile.random(2), v + tile.random(3), 9, 4);
            double grain = noise.cloud(u, v, 90, 1);
            PaintColour clay = PaintColour.TERRACOTTA.mix(PaintColour.BRICK, 0.3 + 0.3 * tile.random(4));
            texel.colour = PaintColour.MORTAR.times(0.72);
            texel.blend(clay.times(1 + 0.09 * (tile.random(5) - 0.5) + 0.06 * cloudy + 0.02 * grain), body);
            double pillow = Shapes.ramp(0, 0.03, tile.edge());
            texel.height = 0.003 * body + 0.0012 * pillow + 0.0006 * cloudy;
            texel.roughness = 1 - body * (0.22 + 0.08 * cloudy);
        });
    }

    /** Paints glazed tesserae in sea colours. */
    static void mosaic(Surface surface) {
        surface.each((x, y, texel) -> tessera(surface.metres(), x, y, texel));
    }

    private static void tessera(double metres, double x, double y, Texel texel) {
        Bond.Piece stone = new Bond(metres, TESSERAE, TESSERAE, 0).at(x, y);
        double body = Shapes.ramp(0.002, 0.007, stone.edge());
        double drift = 0.5 + 0.5 * new TileNoise(91).cloud(x / metres, y / metres, 3, 3);
        double pick = 0.55 * stone.random(2) + 0.45 * drift;
        PaintColour glaze = PaintColour.TEAL.times(0.8).mix(PaintColour.TEAL, Shapes.ramp(0.2, 0.45, pick));
        glaze = glaze.mix(PaintColour.TEAL_PALE, Shapes.ramp(0.55, 0.8, pick));
        if (stone.random(4) > 0.985) {
            glaze = PaintColour.SIGNAL;
        }
        texel.colour = PaintColour.MORTAR.times(0.9);
        texel.blend(glaze.times(0.94 + 0.12 * stone.random(3)), body);
        double tiltX = (stone.random(5) - 0.5) * 0.04 * stone.x();
        double tiltY = (stone.random(6) - 0.5) * 0.04 * stone.y();
        texel.height = body * (0.002 + tiltX + tiltY);
        texel.roughness = 1 - 0.75 * body;
    }

    /** Paints the mosaic under about 0.1 m of rippled water, with the caustics of the ripples. */
    static void water(Surface surface) {
        TileNoise noise = new TileNoise(97);
        surface.each((x, y, texel) -> {
            double u = x / surface.metres();
            double v = y / surface.metres();
            double rippleX = noise.cloud(u, v, 5, 3);
            double rippleY = noise.cloud(u + 0.5, v + 0.25, 5, 3);
            tessera(surface.metres(), x + 0.03 * rippleX, y + 0.03 * rippleY, texel);
            texel.blend(PaintColour.TEAL.times(0.62), 0.5);
            TileNoise.Cell net = noise.cell(u + 0.02 * rippleX, v + 0.02 * rippleY, 9);
            double caustic = 1 - Shapes.ramp(0, 0.22, net.second() - net.nearest());
            texel.blend(PaintColour.TEAL_PALE.mix(PaintColour.PANEL, 0.4), 0.34 * caustic * caustic);
            texel.height = 0.006 * rippleX + 0.0012 * noise.cloud(u, v, 20, 2);
            texel.roughness = 1;
        });
    }
}
