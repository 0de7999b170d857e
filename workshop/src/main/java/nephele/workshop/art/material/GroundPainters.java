package nephele.workshop.art.material;

import nephele.workshop.art.paint.Bond;
import nephele.workshop.art.paint.PaintColour;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.Surface;
import nephele.workshop.art.paint.Surface.Texel;
import nephele.workshop.art.paint.TileNoise;

/** Painters of concrete, plaster, limestone, terrazzo and gravel. */
final class GroundPainters {
    private static final int BLADES = 26000;

    private static final PaintColour CLIFF = PaintColour.JOINT.mix(PaintColour.CHARCOAL, 0.2);

    private GroundPainters() {}

    /** Paints cast panels of 2 × 1 m with V-joints and the holes of the formwork ties. */
    static void concrete(Surface surface) {
        Bond panels = new Bond(surface.metres(), 1, 2, 0);
        TileNoise noise = new TileNoise(11);
        surface.each((x, y, texel) -> {
            double u = x / surface.metres();
            double v = y / surface.metres();
            Bond.Piece panel = panels.at(x, y);
            double mottle = noise.cloud(u, v, 3, 5);
            double rain = noise.stretched(u, v, 24, 2, 3) * Shapes.ramp(-0.2, 0.5, panel.y());
            double grain = noise.cloud(u + 0.37, v + 0.11, 64, 2);
            texel.colour = PaintColour.CONCRETE;
            texel.shade(1 + 0.035 * mottle + 0.014 * rain + 0.018 * grain + 0.03 * (panel.random(3) - 0.5));
            texel.height = 0.0006 * mottle + 0.0003 * grain;
            texel.roughness = 0.93 + 0.07 * mottle;
            pits(noise, u, v, texel);
            ties(panel, texel);
            groove(texel, panel.edge(), 0.009);
        });
    }

    private static void pits(TileNoise noise, double u, double v, Texel texel) {
        TileNoise.Cell pit = noise.cell(u, v, 34);
        double size = 0.1 * Math.max(0, pit.identity() - 0.72) / 0.28;
        double depth = 1 - Shapes.ramp(size * 0.4, size + 0.02, pit.nearest());
        if (size > 0) {
            texel.shade(1 - 0.2 * depth);
            texel.height -= 0.002 * depth;
        }
    }

    private static void ties(Bond.Piece panel, Texel texel) {
        double dx = Math.abs(panel.x()) - 0.7;
        double dy = Math.abs(panel.y()) - 0.3;
        double hole = Shapes.disc(dx, dy, 0.016, 0.008);
        double rim = Shapes.disc(dx, dy, 0.03, 0.02);
        texel.shade((1 - 0.55 * hole) * (1 - 0.06 * rim));
        texel.height -= 0.006 * hole + 0.001 * rim;
    }

    /** Cuts a joint with sides that slope down over {@code halfWidth} metres. */
    static void groove(Texel texel, double edge, double halfWidth) {
        double depth = 1 - Shapes.ramp(0, halfWidth, edge);
        texel.shade(1 - 0.5 * depth);
        texel.height -= 0.6 * halfWidth * depth;
    }

    /** Paints warm lime plaster with broad, barely visible trowel strokes. */
    static void plaster(Surface surface) {
        TileNoise noise = new TileNoise(23);
        surface.each((x, y, texel) -> {
            double u = x / surface.metres();
            double v = y / surface.metres();
            double bend = 0.04 * noise.cloud(u, v, 3, 3);
            double stroke = noise.stretched(u + bend, v - bend, 4, 11, 4);
            double cross = noise.stretched(u - bend, v + bend, 9, 4, 3);
            double grain = noise.cloud(u, v, 96, 1);
            texel.colour =
                    PaintColour.PLASTER.mix(PaintColour.LIMESTONE, 0.12 * Shapes.ramp(0, 1, noise.cloud(v, u, 2, 3)));
            texel.shade(1 + 0.016 * stroke + 0.01 * cross + 0.006 * grain);
            texel.height = 0.0014 * stroke + 0.001 * cross + 0.00012 * grain;
            texel.roughness = 0.96 + 0.04 * stroke;
        });
    }

    /** Paints slabs of limestone, 1 × 0.5 m in running bond, with worn edges. */
    static void paver(Surface surface) {
        Bond slabs = new Bond(surface.metres(), 2, 4, 0.5);
        TileNoise noise = new TileNoise(37);
        surface.each((x, y, texel) -> {
            double u = x / surface.metres();
            double v = y / surface.metres();
            Bond.Piece slab = slabs.at(x, y);
            double move = slab.random(5);
            double vein = noise.stretched(u + move, v + 3 * move, 4, 9, 5);
            double grain = noise.cloud(u, v, 80, 2);
            texel.colour = PaintColour.LIMESTONE.mix(PaintColour.CONCRETE, 0.5 * slab.random(6));
            texel.shade(1 + 0.07 * (slab.random(8) - 0.5) + 0.035 * vein + 0.022 * grain);
            double wear = 0.004 * noise.cloud(u, v, 20, 3);
            double rounded = 1 - Shapes.ramp(0.004, 0.018, slab.edge() + wear);
            texel.height = 0.0007 * vein + 0.0003 * grain - 0.005 * rounded * rounded;
            texel.roughness = 0.9 + 0.08 * vein;
            double joint = 1 - Shapes.ramp(0.003, 0.008, slab.edge() + wear / 2);
            texel.blend(PaintColour.JOINT.times(1 + 0.1 * grain), 0.85 * joint);
        });
    }

    /** Paints polished slabs of 1 m with chips of stone, separated by thin dark strips. */
    static void terrazzo(Surface surface) {
        Bond slabs = new Bond(surface.metres(), 2, 2, 0);
        TileNoise noise = new TileNoise(41);
        PaintColour[] chips = {
            PaintColour.PLASTER,
            PaintColour.CHARCOAL,
            PaintColour.TERRACOTTA,
            PaintColour.JOINT,
            PaintColour.LIMESTONE,
            PaintColour.PANEL
        };
        surface.each((x, y, texel) -> {
            double u = x / surface.metres();
            double v = y / surface.metres();
            Bond.Piece slab = slabs.at(x, y);
            texel.colour = PaintColour.TERRAZZO;
            texel.shade(1 + 0.02 * (slab.random(2) - 0.5) + 0.02 * noise.cloud(u, v, 3, 3));
            texel.roughness = 1;
            for (int layer = 0; layer < 3; layer++) {
                chip(new TileNoise(50 + layer).cell(u, v, 34 << layer), chips, texel);
            }
            double strip = Shapes.line(slab.edge(), 0.004, 0.003);
            texel.blend(PaintColour.METAL, 0.8 * strip);
            texel.height = -0.0008 * strip;
        });
    }

    private static void chip(TileNoise.Cell cell, PaintColour[] chips, Texel texel) {
        double gap = cell.second() - cell.nearest();
        double kept = cell.identity() > 0.45 ? 1 : 0;
        double cover = kept * Shapes.ramp(0.22, 0.34, gap) * (1 - Shapes.ramp(0.3, 0.42, cell.nearest()));
        int kind = (int) (cell.identity() * 977) % chips.length;
        texel.blend(chips[kind], 0.45 * cover);
        texel.roughness = Math.min(texel.roughness, 1 - 0.25 * cover);
    }

    /** Paints pale pebbles in two sizes. */
    static void gravel(Surface surface) {
        TileNoise large = new TileNoise(61);
        TileNoise small = new TileNoise(67);
        surface.each((x, y, texel) -> {
            double u = x / surface.metres();
            double v = y / surface.metres();
            TileNoise.Cell stone = large.cell(u, v, 44);
            TileNoise.Cell grit = small.cell(u, v, 88);
            double above =
                    Shapes.ramp(0.05, 0.3, stone.second() - stone.nearest()) * Shapes.ramp(0.25, 0.4, stone.identity());
            double below = Shapes.ramp(0.02, 0.3, grit.second() - grit.nearest());
            PaintColour tone =
                    PaintColour.LIMESTONE.mix(stone.identity() > 0.7 ? PaintColour.JOINT : PaintColour.CONCRETE, 0.6);
            texel.colour = PaintColour.LIMESTONE.times(0.55 + 0.3 * below * (0.6 + 0.4 * grit.identity()));
            texel.blend(tone.times(0.78 + 0.3 * (stone.identity() * 13 % 1)), above);
            double dome = Math.max(0, 0.7 - stone.nearest());
            texel.height = above * (0.006 + 0.016 * dome) + (1 - above) * 0.004 * below;
            texel.roughness = 1;
        });
    }

    /** Painter of natural rock: beds of stone that lie almost level, broken into blocks, with weathered edges. */
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
            texel.colour = CLIFF.mix(PaintColour.LIMESTONE, 0.25 * Shapes.ramp(-0.3, 0.7, bed + 0.5 * tilt));
            texel.shade(1 + 0.16 * bed + 0.2 * rough + 0.16 * (block.identity() - 0.5));
            texel.height = 0.03 * bed + 0.035 * rough + 0.05 * tilt + 0.03 * block.identity();
            texel.roughness = 1;
            cliffCrack(texel, block, noise.cloud(u, v, 4, 3), surface.metres());
            double lichen = Shapes.ramp(0.3, 0.75, noise.cloud(u + 0.5, v, 6, 5));
            texel.blend(PaintColour.LEAF.mix(PaintColour.LIMESTONE, 0.6), 0.22 * lichen);
        });
    }

    private static void cliffCrack(Texel texel, TileNoise.Cell block, double open, double metres) {
        double depth = Shapes.ramp(-0.1, 0.6, open) * (1 - Shapes.ramp(0, 0.07, block.second() - block.nearest()));
        texel.shade(1 - 0.4 * depth);
        texel.height -= 0.02 * metres * depth;
    }

    /** Painter of a short lawn: thousands of overlapping blades, later ones on top. */
    static void lawn(Surface surface) {
        TileNoise noise = new TileNoise(211);
        surface.each((x, y, texel) -> {
            texel.colour =
                    PaintColour.LEAF.times(0.42 + 0.06 * noise.cloud(x / surface.metres(), y / surface.metres(), 5, 4));
            texel.roughness = 1;
        });
        for (int blade = 0; blade < BLADES; blade++) {
            blade(surface, noise, blade);
        }
    }

    private static void blade(Surface surface, TileNoise noise, int blade) {
        double metres = surface.metres();
        double x = TileNoise.random(blade, 0, 1) * metres;
        double y = TileNoise.random(blade, 0, 2) * metres;
        double angle = 2 * Math.PI * TileNoise.random(blade, 0, 3);
        double length = 0.025 + 0.045 * TileNoise.random(blade, 0, 4);
        double depth = blade / (double) BLADES;
        double dry = Shapes.ramp(0.1, 0.9, noise.cloud(x / metres, y / metres, 4, 3)) * TileNoise.random(blade, 0, 5);
        PaintColour colour =
                PaintColour.LEAF.mix(PaintColour.LIMESTONE, 0.35 * dry).times(0.6 + 0.42 * depth);
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
