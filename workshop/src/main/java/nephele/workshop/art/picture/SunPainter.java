package nephele.workshop.art.picture;

import nephele.workshop.art.paint.ColourRamp;
import nephele.workshop.art.paint.PaintColour;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.SphereNoise;
import org.joml.Vector3dc;

/** Painter of a star: granules of rising gas, bright veins around them and a few groups of spots. */
final class SunPainter implements Globe.Brush {
    private static final ColourRamp FIRE =
            ColourRamp.of(0x8A2A06, 0xC64A0A, 0xEB7B14, 0xF9A828, 0xFFCB4E, 0xFFE58A, 0xFFF6CF);

    private final SphereNoise gas = new SphereNoise(907);

    @Override
    public PaintColour at(Vector3dc p) {
        double flow = gas.cloud(gas.warped(p, 3, 4, 0.25), 2.4, 5);
        double grains = gas.ridges(gas.warped(p, 6, 2, 0.06), 13, 2);
        double belt = 1 - Shapes.ramp(0.25, 0.55, Math.abs(p.y()));
        double spots = belt * Shapes.ramp(0.5, 0.66, gas.cloud(p, 4.2, 3) + 0.1 * grains);
        return FIRE.at(0.6 + 0.26 * flow + 0.22 * (grains - 0.45)).mix(FIRE.at(0.05), 0.85 * spots);
    }
}
