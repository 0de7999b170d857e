package nephele.workshop.art.picture;

import nephele.workshop.art.paint.ColourRamp;
import nephele.workshop.art.paint.PaintColour;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.SphereNoise;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Painter of an Earth-like planet with invented continents: seas, plains, deserts, forests, mountains, ice and clouds.
 */
final class EarthPainter implements Globe.Brush {
    private static final double SEA_LEVEL = 0.04;
    private static final ColourRamp SEA = ColourRamp.of(0x0A1F4A, 0x0F316B, 0x15478A, 0x2C77A8, 0x4FA3B8);
    private static final PaintColour DESERT = PaintColour.of(0xD2B27A);
    private static final PaintColour STEPPE = PaintColour.of(0xA59B5E);
    private static final PaintColour FOREST = PaintColour.of(0x3F6B37);
    private static final PaintColour JUNGLE = PaintColour.of(0x275A2C);
    private static final PaintColour TUNDRA = PaintColour.of(0x8A8A70);
    private static final PaintColour ROCK = PaintColour.of(0x7B6A58);
    private static final PaintColour SNOW = PaintColour.of(0xF4F7FA);

    private final SphereNoise land = new SphereNoise(613);
    private final SphereNoise climate = new SphereNoise(641);
    private final SphereNoise weather = new SphereNoise(659);

    @Override
    public PaintColour at(Vector3dc p) {
        double height = height(p);
        double ice =
                Shapes.ramp(0.955, 0.97, Math.abs(p.y()) + 0.035 * climate.cloud(p, 5, 4) + 0.12 * Math.max(0, height));
        PaintColour ground = height < 0 ? sea(height) : land(p, height);
        return ground.mix(SNOW, ice).mix(SNOW, 0.92 * clouds(p));
    }

    /** Returns the height above the sea, without a unit. */
    private double height(Vector3dc p) {
        Vector3d moved = land.warped(p, 1.8, 5, 0.3);
        return land.cloud(moved, 1.1, 7) - SEA_LEVEL;
    }

    private static PaintColour sea(double height) {
        return SEA.at(1 - Math.min(1, -height * 3.4));
    }

    private PaintColour land(Vector3dc p, double height) {
        double latitude = Math.abs(p.y());
        double wet = 0.5 + 0.7 * climate.cloud(p, 2.4, 4);
        double trade = Shapes.ramp(0.22, 0.4, latitude) * (1 - Shapes.ramp(0.5, 0.62, latitude));
        PaintColour warm =
                JUNGLE.mix(STEPPE, Shapes.ramp(0.62, 0.25, wet)).mix(DESERT, trade * Shapes.ramp(0.75, 0.4, wet));
        PaintColour mild = FOREST.mix(STEPPE, Shapes.ramp(0.6, 0.3, wet));
        PaintColour green =
                warm.mix(mild, Shapes.ramp(0.5, 0.66, latitude)).mix(TUNDRA, Shapes.ramp(0.76, 0.87, latitude));
        double crest = land.ridges(p, 5, 4) * Shapes.ramp(0.12, 0.45, height);
        PaintColour high = green.mix(ROCK, Shapes.ramp(0.25, 0.6, crest)).mix(SNOW, Shapes.ramp(0.66, 0.85, crest));
        return high.times(1 + 0.1 * land.cloud(p, 26, 3));
    }

    private double clouds(Vector3dc p) {
        Vector3d flow = weather.warped(new Vector3d(p.x(), 1.5 * p.y(), p.z()), 1.7, 5, 0.5);
        double cover = weather.cloud(flow, 2, 6) + 0.12 * StrictMath.cos(9 * p.y());
        return Shapes.ramp(0.12, 0.62, cover);
    }
}
