package nephele.workshop.art.sprite;

import java.awt.image.BufferedImage;
import nephele.workshop.art.paint.PaintColour;

/** Painters of low plants: an oleander in bloom, lavender, and a tuft of grass. */
final class HerbPainters {
    private HerbPainters() {}

    static BufferedImage bush() {
        SpriteCanvas canvas = new SpriteCanvas(384, 288, 113);
        for (int i = 0; i < 26; i++) {
            double x = canvas.between(-0.4, 0.4);
            canvas.stroke(0.25 * x, 0, x, canvas.between(0.3, 0.6), 0.014, 0.006, PaintColour.of(0x5a4a35));
        }
        double[][] balls = {
            {-0.36, 0.3, 0.22},
            {0.37, 0.31, 0.22},
            {-0.14, 0.46, 0.28},
            {0.17, 0.5, 0.28},
            {0.0, 0.28, 0.26},
            {-0.46, 0.2, 0.14},
            {0.48, 0.2, 0.14},
            {0.02, 0.66, 0.2}
        };
        TreePainters.crown(
                canvas, balls, PaintColour.of(0x1b3a1f), PaintColour.of(0x84ab52), new double[] {0.075, 0.018}, 0.85);
        for (int i = 0; i < 46; i++) {
            blossom(canvas, canvas.between(-0.5, 0.5), canvas.between(0.3, 0.8));
        }
        return canvas.picture();
    }

    private static void blossom(SpriteCanvas canvas, double x, double y) {
        boolean isOnBush = x * x / 0.27 + (y - 0.35) * (y - 0.35) / 0.2 < 1;
        PaintColour petal = PaintColour.of(0xd9628a).mix(PaintColour.of(0xf7b9cb), canvas.random());
        for (int i = 0; i < 5 && isOnBush; i++) {
            double angle = 2 * Math.PI * i / 5 + x * 40;
            canvas.leaf(
                    x + 0.014 * StrictMath.cos(angle),
                    y + 0.014 * StrictMath.sin(angle),
                    0.03,
                    0.02,
                    angle,
                    petal.times(0.9 + 0.05 * i));
        }
        if (isOnBush) {
            canvas.leaf(x, y, 0.011, 0.011, 0, PaintColour.of(0xf4d58a));
        }
    }

    static BufferedImage grass() {
        SpriteCanvas canvas = new SpriteCanvas(256, 256, 127);
        PaintColour deep = PaintColour.of(0x33521f);
        PaintColour dry = PaintColour.of(0xc4b76a);
        for (int i = 0; i < 150; i++) {
            double fraction = i / 150.0;
            double root = canvas.between(-0.16, 0.16);
            double lean = canvas.between(-0.55, 0.55) + root;
            double tall = canvas.between(0.45, 0.97) * (1.05 - 0.45 * Math.abs(lean)) * (1 - 0.35 * fraction);
            PaintColour tint = deep.mix(dry, 0.15 + 0.5 * fraction * canvas.random() + 0.2 * canvas.random());
            blade(canvas, root, lean, tall, tint);
        }
        return canvas.picture();
    }

    private static void blade(SpriteCanvas canvas, double root, double lean, double tall, PaintColour tint) {
        double x = root;
        double y = 0;
        int pieces = 9;
        for (int i = 1; i <= pieces; i++) {
            double t = (double) i / pieces;
            double nextX = root + 0.62 * lean * t * t;
            double nextY = tall * (t - 0.18 * Math.abs(lean) * t * t);
            double thick = 0.019 * (1 - (i - 1.0) / pieces) + 0.003;
            canvas.stroke(x, y, nextX, nextY, thick, 0.019 * (1 - t) + 0.003, tint.times(0.62 + 0.5 * t));
            x = nextX;
            y = nextY;
        }
    }

    static BufferedImage lavender() {
        SpriteCanvas canvas = new SpriteCanvas(256, 256, 131);
        PaintColour stem = PaintColour.of(0x6f8a5a);
        for (int i = 0; i < 60; i++) {
            blade(canvas, canvas.between(-0.1, 0.1), canvas.between(-0.7, 0.7), canvas.between(0.25, 0.45), stem);
        }
        for (int i = 0; i < 44; i++) {
            double root = canvas.between(-0.08, 0.08);
            double tip = root + canvas.between(-0.34, 0.34);
            double tall = canvas.between(0.6, 0.92) - 0.35 * Math.abs(tip);
            canvas.stroke(root, 0.05, tip, tall, 0.008, 0.006, stem.times(0.9));
            PaintColour flower = PaintColour.of(0x5b468f).mix(PaintColour.of(0xab93d6), canvas.random());
            for (int k = 0; k < 16; k++) {
                double t = k / 16.0;
                double side = (k % 2 == 0 ? 0.012 : -0.012) * (1 - 0.6 * t);
                canvas.leaf(
                        tip + side + 0.1 * t * (tip - root),
                        tall + 0.13 * t,
                        0.024,
                        0.016,
                        Math.PI / 2 + side * 20,
                        flower.times(0.8 + 0.35 * t));
            }
        }
        return canvas.picture();
    }
}
