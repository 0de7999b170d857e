package nephele.workshop.art.sprite;

import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.TileNoise;

/** Painter of a mackerel sky: small rounded heaps in rows, in patches. */
final class RipplePainter {
    private RipplePainter() {}

    static double density(double x, double y) {
        double warpedX = x + 0.02 * new TileNoise(443).cloud(x, y, 4, 3);
        double warpedY = y + 0.02 * new TileNoise(449).cloud(x, y, 4, 3);
        double patch = Shapes.ramp(-0.25, 0.45, new TileNoise(457).cloud(x, y, 3, 4));
        double row = 0.5 + 0.5 * StrictMath.sin(2 * Math.PI * (9 * warpedX + 23 * warpedY));
        double heap = 1 - new TileNoise(461).cell(warpedX, warpedY, 34).nearest();
        return Shapes.ramp(0.42, 1.05, 0.45 * row + 0.6 * heap + 0.45 * patch - 0.25) * patch;
    }
}
