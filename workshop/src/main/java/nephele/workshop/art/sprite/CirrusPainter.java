package nephele.workshop.art.sprite;

import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.TileNoise;

/** Painter of the coverage of cirrus: bundles of filaments along x, which the wind has combed and bent. */
final class CirrusPainter {
    private CirrusPainter() {}

    static double coverage(double x, double y) {
        double bent = y + 0.05 * new TileNoise(401).cloud(x, y, 2, 2) + 0.012 * new TileNoise(409).cloud(x, y, 6, 3);
        double along = x + 0.03 * new TileNoise(419).cloud(x, y, 3, 2);
        double bundle = Shapes.ramp(-0.12, 0.5, new TileNoise(421).stretched(along, bent, 3, 9, 3));
        double strand = 0.5 + 0.9 * new TileNoise(431).stretched(along, bent, 3, 36, 3);
        double thread = 0.5 + 0.9 * new TileNoise(433).stretched(along, bent, 6, 130, 1);
        double hair = Math.max(0, 0.8 * strand + 0.5 * thread - 0.25);
        double veil = 0.1 * Shapes.ramp(-0.3, 0.6, new TileNoise(439).cloud(x, y, 2, 4));
        return veil + bundle * hair * (0.5 + 0.7 * hair);
    }
}
