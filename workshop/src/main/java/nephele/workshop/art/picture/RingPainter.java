package nephele.workshop.art.picture;

import java.awt.image.BufferedImage;
import nephele.workshop.art.paint.ColourRamp;
import nephele.workshop.art.paint.Pixels;
import nephele.workshop.art.paint.SphereNoise;
import nephele.workshop.art.paint.TileNoise;

/**
 * Painter of Saturn's rings for a flattened torus. The picture goes once around the planet to the right and once around
 * the tube upwards, so that the rows run outwards from the planet and back.
 */
final class RingPainter {
    private static final int SIDE = 256;
    private static final ColourRamp ICE = ColourRamp.of(0x4A4136, 0x7D6F5B, 0xA8977B, 0xCDBD9C, 0xE7DAbF);

    private RingPainter() {}

    static BufferedImage paint() {
        SphereNoise noise = new SphereNoise(877);
        TileNoise clumps = new TileNoise(881);
        return Pixels.picture(SIDE, SIDE, (column, row) -> {
            double turn = 1 - (row + 0.5) / SIDE;
            double out = 0.5 - 0.5 * StrictMath.cos(2 * Math.PI * turn);
            double grooves = 0.5 * noise.smooth(5 * out, 0.3, 0.1)
                    + 0.35 * noise.smooth(17 * out, 4.3, 0.1)
                    + 0.3 * noise.smooth(47 * out, 8.3, 0.1);
            double grain = 0.03 * clumps.stretched((column + 0.5) / SIDE, turn, 8, 48, 2);
            return ICE.at(0.66 + 0.5 * grooves + grain).rgb();
        });
    }
}
