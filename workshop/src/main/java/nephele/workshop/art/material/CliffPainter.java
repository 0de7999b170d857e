package nephele.workshop.art.material;

import nephele.workshop.art.paint.ArtPalette;
import nephele.workshop.art.paint.PaintColour;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.Surface;
import nephele.workshop.art.paint.Surface.Texel;
import nephele.workshop.art.paint.TileNoise;

/** Painter of natural rock: beds of stone that lie almost level, broken into blocks, with weathered edges. */
final class CliffPainter {
    private static final PaintColour STONE = ArtPalette.JOINT.mix(ArtPalette.CHARCOAL, 0.2);

    private CliffPainter() {}

    static void cliff(Surface surface) {
        TileNoise noise = new TileNoise(307);
        TileNoise blocks = new TileNoise(311);
        surface.each((x, y, texel) -> {
            double u = x / surface.metres();
            double v = y / surface.metres();
            double bend = 0.05 * noise.cloud(u, v, 2, 4);
            double bed = noise.stretched(u, v + bend, 2, 13, 4);
            double rough = noise.cloud(u, v, 9, 6);
            // Blocks are twice as broad as high.
            TileNoise.Cell block = blocks.cell(u + 0.09 * noise.cloud(v, u, 5, 4), 2 * (v + bend), 5);
            double tilt = noise.cloud(u + block.identity(), v + 3 * block.identity(), 4, 2);
            texel.colour = STONE.mix(ArtPalette.LIMESTONE, 0.25 * Shapes.ramp(-0.3, 0.7, bed + 0.5 * tilt));
            texel.shade(1 + 0.16 * bed + 0.2 * rough + 0.16 * (block.identity() - 0.5));
            texel.height = 0.03 * bed + 0.035 * rough + 0.05 * tilt + 0.03 * block.identity();
            texel.roughness = 1;
            crack(texel, block, noise.cloud(u, v, 4, 3), surface.metres());
            double lichen = Shapes.ramp(0.3, 0.75, noise.cloud(u + 0.5, v, 6, 5));
            texel.blend(ArtPalette.LEAF.mix(ArtPalette.LIMESTONE, 0.6), 0.22 * lichen);
        });
    }

    private static void crack(Texel texel, TileNoise.Cell block, double open, double metres) {
        double depth = Shapes.ramp(-0.1, 0.6, open) * (1 - Shapes.ramp(0, 0.07, block.second() - block.nearest()));
        texel.shade(1 - 0.4 * depth);
        texel.height -= 0.02 * metres * depth;
    }
}
