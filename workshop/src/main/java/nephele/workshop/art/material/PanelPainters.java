package nephele.workshop.art.material;

import nephele.workshop.art.paint.Bond;
import nephele.workshop.art.paint.PaintColour;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.Surface;
import nephele.workshop.art.paint.Surface.Texel;
import nephele.workshop.art.paint.TileNoise;

/** Painters of the laboratory's panels: portalable white, ceiling, lamp and dark glass. */
final class PanelPainters {
    private PanelPainters() {}

    /**
     * Paints white plates of 1 m with soft edges, an inlaid line and four flush screws, the material that admits
     * portals.
     */
    static void white(Surface surface) {
        Bond plates = new Bond(surface.metres(), 2, 2, 0);
        TileNoise noise = new TileNoise(151);
        surface.each((x, y, texel) -> {
            double u = x / surface.metres();
            double v = y / surface.metres();
            Bond.Piece plate = plates.at(x, y);
            double haze = noise.cloud(u, v, 4, 4);
            texel.colour = PaintColour.PANEL;
            texel.shade(0.985 + 0.022 * (plate.random(1) - 0.5) + 0.008 * haze);
            texel.roughness = 0.86 + 0.08 * haze;
            double inner = Shapes.roundedBox(plate.x(), plate.y(), 0.43, 0.43, 0.06);
            inlay(texel, inner);
            screws(plate, texel);
            soften(plate, texel);
        });
    }

    private static void inlay(Texel texel, double distance) {
        double line = Shapes.line(distance, 0.004, 0.004);
        texel.shade(1 - 0.13 * line);
        texel.height -= 0.0012 * line;
    }

    private static void screws(Bond.Piece plate, Texel texel) {
        double dx = Math.abs(plate.x()) - 0.455;
        double dy = Math.abs(plate.y()) - 0.455;
        double head = Shapes.disc(dx, dy, 0.011, 0.004);
        double rim = Shapes.disc(dx, dy, 0.014, 0.004) - head;
        texel.blend(PaintColour.CONCRETE, 0.6 * head);
        texel.shade(1 - 0.3 * rim);
        texel.height -= 0.001 * rim;
    }

    private static void soften(Bond.Piece plate, Texel texel) {
        double outline = -Shapes.roundedBox(plate.x(), plate.y(), 0.5, 0.5, 0.02);
        double bevel = 1 - Shapes.ramp(0.003, 0.016, outline);
        texel.height -= 0.006 * bevel * bevel;
        double gap = 1 - Shapes.ramp(0.002, 0.006, outline);
        texel.blend(PaintColour.METAL, 0.75 * gap);
        texel.roughness = Math.max(texel.roughness, gap);
    }

    /** Paints ceiling coffers of 1 m with acoustic perforation inside a plain margin. */
    static void ceiling(Surface surface) {
        Bond coffers = new Bond(surface.metres(), 2, 2, 0);
        Bond holes = new Bond(surface.metres(), 40, 40, 0);
        surface.each((x, y, texel) -> {
            Bond.Piece coffer = coffers.at(x, y);
            Bond.Piece hole = holes.at(x, y);
            double field = 1 - Shapes.ramp(-0.002, 0.002, Math.max(Math.abs(coffer.x()), Math.abs(coffer.y())) - 0.4);
            double bore = field * Shapes.disc(hole.x(), hole.y(), 0.010, 0.006);
            texel.colour = PaintColour.PLASTER.mix(PaintColour.PANEL, 0.6);
            texel.shade(0.985 + 0.02 * (coffer.random(1) - 0.5));
            texel.shade(1 - 0.6 * bore);
            texel.height = -0.003 * bore;
            GroundPainters.groove(texel, coffer.edge(), 0.008);
        });
    }

    /** Paints a lamp's diffuser, 1 m wide, behind a thin grid. The material's emission makes it shine. */
    static void light(Surface surface) {
        Bond cells = new Bond(surface.metres(), 4, 4, 0);
        surface.each((x, y, texel) -> {
            Bond.Piece cell = cells.at(x, y);
            double bar = 1 - Shapes.ramp(0.005, 0.010, cell.edge());
            texel.colour = PaintColour.PANEL.times(0.98 + 0.02 * Shapes.ramp(0, 0.1, cell.edge()));
            texel.blend(PaintColour.METAL, 0.6 * bar);
            texel.height = 0.004 * bar;
        });
    }

    /** Paints dark tinted glass with traces of rain. It is opaque. */
    static void glass(Surface surface) {
        TileNoise noise = new TileNoise(171);
        surface.each((x, y, texel) -> {
            double u = x / surface.metres();
            double v = y / surface.metres();
            double haze = noise.cloud(u, v, 3, 4);
            double drip = Shapes.ramp(0.2, 0.9, noise.stretched(u, v, 40, 3, 2));
            texel.colour = PaintColour.GLASS.mix(PaintColour.TEAL, 0.05 + 0.03 * haze);
            texel.shade(1 + 0.06 * drip);
            texel.height = 0.0002 * haze;
            texel.roughness = 0.6 + 0.2 * haze + 0.2 * drip;
        });
    }
}
