package nephele.workshop.art.sprite;

import java.awt.image.BufferedImage;
import nephele.workshop.art.paint.PaintColour;
import nephele.workshop.art.paint.TileNoise;

/**
 * A transparent picture on which leaves and branches are painted one over the other. Coordinates are in heights of the
 * picture: x from the middle to the right, y from the lower edge up. Painted twice as large and averaged.
 */
final class SpriteCanvas {
    private static final int FINER = 2;

    private final int width;
    private final int height;
    /** Red, green, blue as stored and premultiplied, and alpha. */
    private final float[] rgba;

    private int draws;
    private final int seed;

    SpriteCanvas(int width, int height, int seed) {
        this.width = FINER * width;
        this.height = FINER * height;
        this.seed = seed;
        rgba = new float[4 * this.width * this.height];
    }

    /** Returns the next random number, 0 to 1. */
    double random() {
        draws++;
        return TileNoise.random(draws, draws >> 8, seed);
    }

    /** Returns the next random number between two limits. */
    double between(double low, double high) {
        return low + (high - low) * random();
    }

    /** Paints an ellipse. @param angle of its length to the right, radians */
    void leaf(double x, double y, double length, double breadth, double angle, PaintColour tint) {
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        double reach = Math.max(length, breadth) / 2;
        double soft = 0.7 / height / Math.min(length, breadth) * 2;
        int left = column(x - reach) - 1;
        int right = column(x + reach) + 1;
        for (int row = row(y + reach) - 1; row <= row(y - reach) + 1; row++) {
            for (int column = left; column <= right; column++) {
                double dx = (column + 0.5 - width / 2.0) / height - x;
                double dy = (height - row - 0.5) / height - y;
                double along = (dx * cos + dy * sin) / (length / 2);
                double across = (dy * cos - dx * sin) / (breadth / 2);
                double inside = 1 - Math.sqrt(along * along + across * across);
                // The vein is darker, one half catches more light.
                double shade = 1 - 0.18 * Math.max(0, 1 - 9 * Math.abs(across)) + 0.1 * Math.signum(across);
                put(column, row, Math.min(1, Math.max(0, inside / soft + 0.5)), tint, shade);
            }
        }
    }

    /** Paints a straight piece of a branch or blade that tapers, rounded by shade. */
    void stroke(double x0, double y0, double x1, double y1, double breadth0, double breadth1, PaintColour tint) {
        double dx = x1 - x0;
        double dy = y1 - y0;
        double square = Math.max(1e-12, dx * dx + dy * dy);
        double reach = Math.max(breadth0, breadth1) / 2 + 1.0 / height;
        for (int row = row(Math.max(y0, y1) + reach); row <= row(Math.min(y0, y1) - reach); row++) {
            for (int column = column(Math.min(x0, x1) - reach); column <= column(Math.max(x0, x1) + reach); column++) {
                double px = (column + 0.5 - width / 2.0) / height - x0;
                double py = (height - row - 0.5) / height - y0;
                double along = Math.max(0, Math.min(1, (px * dx + py * dy) / square));
                double offX = px - along * dx;
                double offY = py - along * dy;
                double half = (breadth0 + (breadth1 - breadth0) * along) / 2;
                double off = Math.sqrt(offX * offX + offY * offY);
                double cover = Math.min(1, Math.max(0, (half - off) * height + 0.5));
                double side = half > 0 ? Math.max(-1, Math.min(1, offX / half)) : 0;
                put(column, row, cover, tint, 1 - 0.3 * side - 0.2 * Math.abs(side));
            }
        }
    }

    private int column(double x) {
        return (int) Math.floor(x * height + width / 2.0);
    }

    private int row(double y) {
        return (int) Math.floor(height - y * height);
    }

    private void put(int column, int row, double cover, PaintColour tint, double shade) {
        if (cover <= 0 || column < 0 || row < 0 || column >= width || row >= height) {
            return;
        }
        int at = 4 * (row * width + column);
        float keep = (float) (1 - cover);
        rgba[at] = rgba[at] * keep + (float) (cover * Math.min(1, tint.red() * shade));
        rgba[at + 1] = rgba[at + 1] * keep + (float) (cover * Math.min(1, tint.green() * shade));
        rgba[at + 2] = rgba[at + 2] * keep + (float) (cover * Math.min(1, tint.blue() * shade));
        rgba[at + 3] = rgba[at + 3] * keep + (float) cover;
    }

    /** Returns the picture with straight alpha. */
    BufferedImage picture() {
        var picture = new BufferedImage(width / FINER, height / FINER, BufferedImage.TYPE_INT_ARGB);
        float[] sum = new float[4];
        for (int row = 0; row < picture.getHeight(); row++) {
            for (int column = 0; column < picture.getWidth(); column++) {
                java.util.Arrays.fill(sum, 0);
                for (int i = 0; i < FINER * FINER; i++) {
                    int at = 4 * ((FINER * row + i / FINER) * width + FINER * column + i % FINER);
                    for (int channel = 0; channel < 4; channel++) {
                        sum[channel] += rgba[at + channel];
                    }
                }
                float alpha = Math.max(sum[3], 1e-6f);
                int rgb = code(sum[0] / alpha) << 16 | code(sum[1] / alpha) << 8 | code(sum[2] / alpha);
                int cover = code(sum[3] / (FINER * FINER));
                picture.setRGB(column, row, cover == 0 ? 0 : cover << 24 | rgb);
            }
        }
        return picture;
    }

    private static int code(double value) {
        return (int) Math.round(255 * Math.max(0, Math.min(1, value)));
    }
}
