package nephele.workshop.art.material;

import nephele.workshop.art.paint.Bond;
import nephele.workshop.art.paint.PaintColour;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.Surface;
import nephele.workshop.art.paint.Surface.Texel;
import nephele.workshop.art.paint.TileNoise;

/** Painters of dark coated steel and of warning stripes. */
final class MetalPainters {
    private MetalPainters() {}

    /** Paints plates of 1 × 0.5 m with rows of rivets and with edges rubbed bright. */
    static void plates(Surface surface) {
        Bond plates = new Bond(surface.metres(), 2, 4, 0.5);
        TileNoise noise = new TileNoise(181);
        surface.each((x, y, texel) -> {
            double u = x / surface.metres();
            double v = y / surface.metres();
            Bond.Piece plate = plates.at(x, y);
            coat(noise, u, v, texel);
            texel.shade(1 + 0.1 * (plate.random(4) - 0.5));
            double rubbed = 1 - Shapes.ramp(0.004, 0.016, plate.edge() + 0.008 * noise.cloud(u, v, 24, 3));
            texel.blend(PaintColour.JOINT, 0.35 * rubbed);
            rivets(plate, texel);
            double gap = 1 - Shapes.ramp(0.002, 0.006, plate.edge());
            texel.shade(1 - 0.7 * gap);
            texel.height -= 0.004 * (1 - Shapes.ramp(0.002, 0.010, plate.edge()));
        });
    }

    private static void coat(TileNoise noise, double u, double v, Texel texel) {
        double brushed = noise.stretched(u, v, 4, 128, 2);
        double cloudy = noise.cloud(u, v, 5, 4);
        texel.colour = PaintColour.METAL;
        texel.shade(1 + 0.045 * brushed + 0.06 * cloudy);
        texel.height = 0.00008 * brushed;
        texel.roughness = 0.82 + 0.14 * cloudy;
    }

    private static void rivets(Bond.Piece plate, Texel texel) {
        double pitch = 0.225;
        double along = Math.abs(plate.x() / pitch - Math.rint(plate.x() / pitch)) * pitch;
        double across = Math.abs(plate.y()) - 0.215;
        double head = Shapes.disc(along, across, 0.010, 0.006);
        double ring = Shapes.disc(along, across, 0.016, 0.010);
        texel.shade((1 - 0.25 * ring) * (1 + 0.5 * head));
        texel.height += 0.003 * head;
    }

    /** Paints seamless coated steel for frames, rails and trims. */
    static void frame(Surface surface) {
        TileNoise noise = new TileNoise(191);
        surface.each((x, y, texel) -> coat(noise, x / surface.metres(), y / surface.metres(), texel));
    }

    /** Paints signal and charcoal stripes at 45°, each 125 mm along the edge, with scuffs. */
    static void hazard(Surface surface) {
        TileNoise noise = new TileNoise(199);
        surface.each((x, y, texel) -> {
            double u = x / surface.metres();
            double v = y / surface.metres();
            double phase = (x + y) * 4;
            double offset = Math.abs(phase - Math.floor(phase) - 0.5) - 0.25;
            double stripe = Shapes.ramp(-0.008, 0.008, offset);
            double cloudy = noise.cloud(u, v, 6, 5);
            double scuff = Shapes.ramp(0.42, 0.62, noise.cloud(u + 0.3, v, 9, 6));
            texel.colour = PaintColour.CHARCOAL.mix(PaintColour.SIGNAL, stripe);
            texel.shade(1 + 0.05 * cloudy);
            texel.blend(PaintColour.JOINT, 0.6 * scuff);
            texel.height = 0.0004 * (1 - scuff) + 0.00015 * cloudy;
            texel.roughness = 0.75 + 0.25 * scuff;
        });
    }
}
