package nephele.workshop.art.material;

import nephele.workshop.art.paint.ArtPalette;
import nephele.workshop.art.paint.PaintColour;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.Surface;
import nephele.workshop.art.paint.Surface.Texel;
import nephele.workshop.art.paint.TileNoise;

/** Painter of a short lawn: thousands of overlapping blades, later ones on top. */
final class GrassPainter {
    private static final int BLADES = 26000;

    private GrassPainter() {}

    static void lawn(Surface surface) {
        TileNoise noise = new TileNoise(211);
        surface.each((x, y, texel) -> {
            texel.colour =
                    ArtPalette.LEAF.times(0.42 + 0.06 * noise.cloud(x / surface.metres(), y / surface.metres(), 5, 4));
            texel.roughness = 1;
        });
        for (int blade = 0; blade < BLADES; blade++) {
            draw(surface, noise, blade);
        }
    }

    private static void draw(Surface surface, TileNoise noise, int blade) {
        double metres = surface.metres();
        double x = TileNoise.random(blade, 0, 1) * metres;
        double y = TileNoise.random(blade, 0, 2) * metres;
        double angle = 2 * Math.PI * TileNoise.random(blade, 0, 3);
        double length = 0.025 + 0.045 * TileNoise.random(blade, 0, 4);
        double depth = blade / (double) BLADES;
        double dry = Shapes.ramp(0.1, 0.9, noise.cloud(x / metres, y / metres, 4, 3)) * TileNoise.random(blade, 0, 5);
        PaintColour colour =
                ArtPalette.LEAF.mix(ArtPalette.LIMESTONE, 0.35 * dry).times(0.6 + 0.42 * depth);
        colour = colour.times(0.9 + 0.2 * TileNoise.random(blade, 0, 6));
        double cosine = StrictMath.cos(angle);
        double sine = StrictMath.sin(angle);
        int steps = (int) Math.ceil(length / surface.texelMetres());
        for (int step = 0; step < steps; step++) {
            double along = step * surface.texelMetres();
            double light = 0.75 + 0.3 * step / steps;
            Texel texel = surface.at(x + along * cosine, y + along * sine);
            texel.colour = colour.times(light);
            texel.height = 0.002 * depth + 0.002 * step / steps;
        }
    }
}
