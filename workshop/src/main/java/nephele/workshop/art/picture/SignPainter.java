package nephele.workshop.art.picture;

import java.awt.image.BufferedImage;
import nephele.workshop.art.paint.PaintColour;
import nephele.workshop.art.paint.Pixels;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.TileNoise;

/**
 * Painter of the plate beside the first door: number 01 over a row of clouds, in the signal colour. It is shown once
 * over a face.
 */
public final class SignPainter {
    public static final String FILE = "textures/sign-01.png";
    private static final int SIDE_PIXELS = 512;
    private static final double PIXEL = 1.0 / SIDE_PIXELS;

    private SignPainter() {}

    public static BufferedImage paint() {
        return Pixels.picture(
                SIDE_PIXELS, SIDE_PIXELS, (column, row) -> colour((column + 0.5) * PIXEL, 1 - (row + 0.5) * PIXEL)
                        .rgb());
    }

    /** Returns the colour at x and y, which run 0–1 from the lower left corner. */
    private static PaintColour colour(double x, double y) {
        double border = Shapes.line(Shapes.roundedBox(x - 0.5, y - 0.5, 0.46, 0.46, 0.05), 0.006, 2 * PIXEL);
        double digits = inside(Math.min(zero(x - 0.31, y - 0.6), one(x - 0.69, y - 0.6)));
        double clouds = 0;
        for (int i = 0; i < 3; i++) {
            clouds = Math.max(clouds, inside(cloud(x - 0.25 - 0.25 * i, y - 0.17)) * (i == 0 ? 1 : 0.28));
        }
        PaintColour ground = PaintColour.CHARCOAL.times(1.05 + 0.03 * new TileNoise(401).cloud(x, y, 5, 4));
        return ground.mix(PaintColour.PANEL, 0.5 * border)
                .mix(PaintColour.SIGNAL, digits)
                .mix(PaintColour.PANEL, clouds);
    }

    private static double inside(double distance) {
        return 1 - Shapes.ramp(-PIXEL, PIXEL, distance);
    }

    private static double zero(double x, double y) {
        return Math.abs(Shapes.roundedBox(x, y, 0.115, 0.215, 0.115)) - 0.04;
    }

    private static double one(double x, double y) {
        double stem = Shapes.roundedBox(x - 0.035, y, 0.04, 0.255, 0.01);
        double turnedX = (x + 0.045 + (y - 0.175)) * 0.7071;
        double turnedY = (y - 0.175 - (x + 0.045)) * 0.7071;
        double flag = Shapes.roundedBox(turnedY, turnedX, 0.04, 0.115, 0.01);
        return Math.min(stem, Math.max(flag, y - 0.255));
    }

    /** Returns the signed distance to three discs on a flat base. */
    private static double cloud(double x, double y) {
        double left = Math.sqrt((x + 0.05) * (x + 0.05) + y * y) - 0.04;
        double middle = Math.sqrt(x * x + (y - 0.025) * (y - 0.025)) - 0.055;
        double right = Math.sqrt((x - 0.055) * (x - 0.055) + (y + 0.004) * (y + 0.004)) - 0.036;
        double heap = Math.min(middle, Math.min(left, right));
        double base = Shapes.roundedBox(x, y + 0.02, 0.085, 0.02, 0.02);
        return Math.max(Math.min(heap, base), -0.04 - y);
    }
}
