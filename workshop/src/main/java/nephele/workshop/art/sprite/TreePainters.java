package nephele.workshop.art.sprite;

import java.awt.image.BufferedImage;
import nephele.workshop.art.paint.PaintColour;

/** Painters of trees: the cypresses of the terraces, a stone pine and an olive tree. Light is left to the engine. */
final class TreePainters {
    private static final PaintColour BARK = PaintColour.of(0x7a6250);
    private static final PaintColour BARK_DARK = PaintColour.of(0x4d3c31);

    private TreePainters() {}

    static BufferedImage cypress() {
        SpriteCanvas canvas = new SpriteCanvas(192, 512, 71);
        canvas.stroke(0, 0, 0, 0.16, 0.028, 0.02, BARK);
        PaintColour deep = PaintColour.of(0x16301f);
        PaintColour fresh = PaintColour.of(0x5d8a45);
        for (int layer = 0; layer < 5; layer++) {
            for (int i = 0; i < 1500; i++) {
                double y = canvas.between(0.06, 0.98);
                double half = spindle(y) * (1 - 0.13 * layer);
                double across = canvas.between(-1, 1);
                double x = half * across;
                double light = 0.16 * layer + 0.16 * y + 0.25 * canvas.random() - 0.14 * Math.abs(across);
                double lean = Math.PI / 2 - 0.55 * across + canvas.between(-0.35, 0.35);
                canvas.leaf(x, y, canvas.between(0.018, 0.042), 0.008, lean, deep.mix(fresh, light));
            }
        }
        return canvas.picture();
    }

    /** Returns half the breadth of a cypress at a height. */
    private static double spindle(double y) {
        double t = Math.max(0, Math.min(1, (y - 0.05) / 0.93));
        return 0.155 * StrictMath.pow(StrictMath.sin(Math.PI * StrictMath.pow(t, 0.62)), 0.62) * (1 - 0.45 * t) + 0.006;
    }

    /** An umbrella on a bare, slightly bent trunk. */
    static BufferedImage pine() {
        SpriteCanvas canvas = new SpriteCanvas(448, 512, 83);
        double[][] balls = {
            {-0.24, 0.70, 0.13}, {0.25, 0.69, 0.13}, {-0.11, 0.77, 0.15}, {0.12, 0.78, 0.15}, {0, 0.72, 0.14},
            {-0.33, 0.655, 0.08}, {0.34, 0.65, 0.08}, {0.01, 0.835, 0.12}, {-0.18, 0.8, 0.10}, {0.2, 0.8, 0.1}
        };
        trunk(canvas, new double[][] {{0.02, 0}, {-0.005, 0.2}, {0.01, 0.42}, {0, 0.62}}, 0.06, 0.034);
        for (double[] ball : balls) {
            canvas.stroke(0.004, 0.46, 0.5 * ball[0], 0.58, 0.026, 0.016, BARK_DARK);
            canvas.stroke(0.5 * ball[0], 0.58, ball[0], ball[1], 0.016, 0.006, BARK_DARK);
        }
        crown(canvas, balls, PaintColour.of(0x1f3a1c), PaintColour.of(0x7f9c46), new double[] {0.034, 0.0065}, 0.62);
        return canvas.picture();
    }

    /** A gnarled trunk that forks, under small silvery leaves with gaps between the clumps. */
    static BufferedImage olive() {
        SpriteCanvas canvas = new SpriteCanvas(448, 448, 97);
        double[][] balls = {
            {-0.26, 0.52, 0.13}, {0.27, 0.56, 0.14}, {-0.14, 0.7, 0.15}, {0.13, 0.74, 0.15}, {0, 0.55, 0.12},
            {-0.36, 0.62, 0.08}, {0.38, 0.46, 0.08}, {0.0, 0.84, 0.11}, {0.3, 0.72, 0.1}, {-0.3, 0.76, 0.1}
        };
        trunk(canvas, new double[][] {{-0.02, 0}, {0.03, 0.1}, {-0.01, 0.22}, {-0.1, 0.36}, {-0.16, 0.55}}, 0.1, 0.03);
        trunk(canvas, new double[][] {{0.0, 0.17}, {0.07, 0.3}, {0.13, 0.42}, {0.16, 0.6}}, 0.055, 0.022);
        for (double[] ball : balls) {
            double from = ball[0] < 0 ? -0.12 : 0.12;
            canvas.stroke(from, 0.42, ball[0], ball[1], 0.02, 0.006, BARK_DARK);
        }
        crown(canvas, balls, PaintColour.of(0x36452c), PaintColour.of(0xabb583), new double[] {0.03, 0.009}, 0.5);
        return canvas.picture();
    }

    private static void trunk(SpriteCanvas canvas, double[][] points, double thick, double thin) {
        int pieces = points.length - 1;
        for (int i = 0; i < pieces; i++) {
            double from = thick + (thin - thick) * i / pieces;
            double to = thick + (thin - thick) * (i + 1) / pieces;
            canvas.stroke(points[i][0], points[i][1], points[i + 1][0], points[i + 1][1], from, to, BARK);
        }
        for (int i = 0; i < 90; i++) {
            double along = canvas.between(0, pieces);
            int piece = Math.min(pieces - 1, (int) along);
            double part = along - piece;
            double half = (thick + (thin - thick) * along / pieces) / 2;
            double x = points[piece][0]
                    + (points[piece + 1][0] - points[piece][0]) * part
                    + half * canvas.between(-0.8, 0.8);
            double y = points[piece][1] + (points[piece + 1][1] - points[piece][1]) * part;
            canvas.leaf(x, y, canvas.between(0.02, 0.045), 0.004, Math.PI / 2 + canvas.between(-0.3, 0.3), BARK_DARK);
        }
    }

    /**
     * Fills balls with leaves, from the dark ones within to the light ones in front and above.
     *
     * @param leaf length and breadth
     * @param flat height of the balls by their breadth
     */
    static void crown(
            SpriteCanvas canvas, double[][] balls, PaintColour deep, PaintColour fresh, double[] leaf, double flat) {
        for (int layer = 0; layer < 6; layer++) {
            for (double[] ball : balls) {
                int count = (int) (52_000 * ball[2] * ball[2] * flat);
                for (int i = 0; i < count; i++) {
                    double angle = canvas.between(0, 2 * Math.PI);
                    double out = Math.sqrt(canvas.random()) * (1.12 - 0.1 * layer);
                    double x = ball[0] + ball[2] * out * StrictMath.cos(angle);
                    double y = ball[1] + ball[2] * flat * out * StrictMath.sin(angle) + 0.006 * layer;
                    double above = 0.5 + 0.5 * out * StrictMath.sin(angle);
                    double light = 0.11 * layer + 0.3 * above + 0.3 * canvas.random() - 0.12;
                    double turn = angle + canvas.between(-0.9, 0.9);
                    canvas.leaf(x, y, leaf[0] * canvas.between(0.6, 1.1), leaf[1], turn, deep.mix(fresh, light));
                }
            }
        }
    }
}
