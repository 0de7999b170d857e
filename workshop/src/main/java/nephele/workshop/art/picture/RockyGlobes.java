package nephele.workshop.art.picture;

import nephele.workshop.art.paint.ColourRamp;
import nephele.workshop.art.paint.PaintColour;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.SphereNoise;
import org.joml.Vector3dc;

/** Painters of planets and moons with a visible ground. */
final class RockyGlobes {
    private RockyGlobes() {}

    static Globe.Brush mercury() {
        ColourRamp ground = ColourRamp.of(0x4A4440, 0x6E655D, 0x938779, 0xB9AC9B);
        Craters craters = new Craters(711, 700, 0.2);
        SphereNoise noise = new SphereNoise(701);
        return p -> {
            double tone = 0.5 + 0.42 * noise.cloud(p, 2.2, 6) + 0.08 * noise.cloud(p, 22, 2);
            return ground.at(tone + 0.3 * craters.relief(p));
        };
    }

    static Globe.Brush moon() {
        ColourRamp ground = ColourRamp.of(0x55555A, 0x77777A, 0xA3A29E, 0xD3D1CA);
        Craters craters = new Craters(733, 520, 0.17);
        SphereNoise noise = new SphereNoise(727);
        return p -> {
            double sea = Shapes.ramp(0.02, 0.3, noise.cloud(noise.warped(p, 2, 3, 0.2), 1.4, 4));
            double tone = 0.62 + 0.12 * noise.cloud(p, 6, 5) - 0.42 * sea;
            return ground.at(tone + 0.26 * craters.relief(p) * (1 - 0.55 * sea));
        };
    }

    static Globe.Brush mars() {
        ColourRamp ground = ColourRamp.of(0x4A2A20, 0x7E412A, 0xB4633A, 0xD18B57, 0xE3B182);
        Craters craters = new Craters(743, 140, 0.1);
        SphereNoise noise = new SphereNoise(739);
        PaintColour ice = PaintColour.of(0xF3EDE6);
        return p -> {
            double plains = noise.cloud(noise.warped(p, 2.4, 4, 0.28), 1.5, 6);
            double tone = 0.58 + 0.62 * plains + 0.08 * noise.cloud(p, 18, 3) + 0.12 * craters.relief(p);
            PaintColour soil = ground.at(tone).mix(PaintColour.of(0x38201A), 0.75 * canyon(p, noise));
            double north = Shapes.ramp(0.975, 0.985, p.y() + 0.03 * noise.cloud(p, 7, 4));
            double south = Shapes.ramp(0.982, 0.99, -p.y() + 0.025 * noise.cloud(p, 6, 4));
            return soil.mix(ice, Math.max(north, south));
        };
    }

    /** Returns the weight of a long canyon a little south of the equator. */
    private static double canyon(Vector3dc p, SphereNoise noise) {
        double across = p.y() + 0.13 + 0.05 * noise.cloud(p, 4, 4) + 0.03 * p.x();
        double along = Shapes.ramp(0.25, 0.6, p.z()) * (1 - Shapes.ramp(0.55, 0.75, Math.abs(p.x())));
        double branch = 0.013 + 0.016 * noise.cloud(p, 9, 3);
        return along * Shapes.line(across, branch, 0.02);
    }

    /** Paints cracked ice over an ocean. */
    static Globe.Brush europa() {
        ColourRamp ice = ColourRamp.of(0xA78F77, 0xD0C3B2, 0xE9E4DA, 0xF7F5F0);
        SphereNoise noise = new SphereNoise(751);
        PaintColour rust = PaintColour.of(0x7A4630);
        return p -> {
            double broad = Shapes.ramp(0.62, 0.75, noise.ridges(noise.warped(p, 2, 2, 0.2), 1.7, 1) / 0.55 - 0.2);
            double fine = Shapes.ramp(0.72, 0.98, noise.ridges(p, 4, 1) / 0.55);
            PaintColour plain = ice.at(0.62 + 0.5 * noise.cloud(p, 2.4, 5));
            return plain.mix(rust, 0.7 * broad).mix(rust, 0.45 * fine);
        };
    }

    /** Paints sulphur with dark volcanic vents. */
    static Globe.Brush io() {
        ColourRamp sulphur = ColourRamp.of(0x8F6A2A, 0xC9A03C, 0xE6C95C, 0xF2E59A, 0xF6F0D0);
        Craters vents = new Craters(761, 46, 0.16);
        SphereNoise noise = new SphereNoise(757);
        return p -> {
            double vent = vents.relief(p);
            PaintColour plain = sulphur.at(0.55 + 0.5 * noise.cloud(noise.warped(p, 3, 3, 0.2), 2, 5));
            return plain.mix(PaintColour.of(0x3A2418), Math.max(0, -1.5 * vent))
                    .mix(PaintColour.of(0xC8502A), 0.8 * Math.max(0, vent));
        };
    }
}
