package nephele.engine.render;

import nephele.engine.render.frame.Quality.Upscale;
import nephele.engine.render.pass.upscale.UpscalePass;

/** The filters that scale a picture up, in double precision, for one channel or three equal ones. */
final class UpscaleTwin {
    private final double[] small;
    private final int width;
    private final int height;

    /** @param small values of the texels, the bottom row first */
    UpscaleTwin(double[] small, int width) {
        this.small = small;
        this.width = width;
        height = small.length / width;
    }

    /**
     * Returns the value at a place.
     *
     * @param x in texels; the centre of the first one is 0
     * @param y likewise
     */
    double at(double x, double y, Upscale filter) {
        return switch (filter) {
            case BILINEAR -> bilinear(x, y, 1);
            case SHARP_BILINEAR -> bilinear(x, y, UpscalePass.STEEPNESS);
            case EDGE_ADAPTIVE -> edgeAdaptive(x, y);
        };
    }

    private double texel(int x, int y) {
        return small[width * Math.max(0, Math.min(height - 1, y)) + Math.max(0, Math.min(width - 1, x))];
    }

    private double bilinear(double x, double y, double steepness) {
        int left = (int) Math.floor(x);
        int below = (int) Math.floor(y);
        double across = weight(x - left, steepness);
        double up = weight(y - below, steepness);
        return (1 - up) * ((1 - across) * texel(left, below) + across * texel(left + 1, below))
                + up * ((1 - across) * texel(left, below + 1) + across * texel(left + 1, below + 1));
    }

    private static double weight(double part, double steepness) {
        return Math.max(0, Math.min(1, (part - 0.5) * steepness + 0.5));
    }

    private double edgeAdaptive(double x, double y) {
        int left = (int) Math.floor(x);
        int below = (int) Math.floor(y);
        double gradientX = 0;
        double gradientY = 0;
        double strength = 0;
        for (int corner = 0; corner < 4; corner++) {
            int atX = left + corner % 2;
            int atY = below + corner / 2;
            double weight = (1 - Math.abs(x - atX)) * (1 - Math.abs(y - atY));
            double acrossX = 2 * (texel(atX + 1, atY) - texel(atX - 1, atY));
            double acrossY = 2 * (texel(atX, atY + 1) - texel(atX, atY - 1));
            gradientX += weight * acrossX;
            gradientY += weight * acrossY;
            strength += weight
                    * (square(sharpness(acrossX, texel(atX - 1, atY), texel(atX, atY), texel(atX + 1, atY)))
                            + square(sharpness(acrossY, texel(atX, atY - 1), texel(atX, atY), texel(atX, atY + 1))));
        }
        strength = square(strength / 2);
        double length = Math.hypot(gradientX, gradientY);
        boolean isFlat = square(length) < 1.0 / 32768;
        double cosine = isFlat ? 1 : gradientX / length;
        double sine = isFlat ? 0 : gradientY / length;
        double stretch = 1 / Math.max(Math.abs(cosine), Math.abs(sine));
        double across = 1 + (stretch - 1) * strength;
        double along = 1 - strength / 2;
        double lobe = 0.5 - 0.29 * strength;
        double sum = 0;
        double weights = 0;
        double least = 1;
        double most = 0;
        for (int row = -1; row <= 2; row++) {
            for (int column = -1; column <= 2; column++) {
                boolean isInner = (row == 0 || row == 1) && (column == 0 || column == 1);
                boolean isCorner = (row == -1 || row == 2) && (column == -1 || column == 2);
                double texel = texel(left + column, below + row);
                if (isInner) {
                    least = Math.min(least, texel);
                    most = Math.max(most, texel);
                }
                if (!isCorner) {
                    double toX = left + column - x;
                    double toY = below + row - y;
                    double weight = kernel(
                            square(across * (toX * cosine + toY * sine)) + square(along * (toY * cosine - toX * sine)),
                            lobe);
                    sum += weight * texel;
                    weights += weight;
                }
            }
        }
        return Math.max(least, Math.min(most, sum / weights));
    }

    /** Returns how little of a gradient is a thin line: 1 for a step or a ramp. */
    private static double sharpness(double across, double before, double here, double after) {
        double steepest = 2 * Math.max(Math.abs(after - here), Math.abs(here - before));
        return Math.min(1, Math.abs(across) / Math.max(steepest, 1e-5));
    }

    private static double kernel(double squaredDistance, double lobe) {
        double squared = Math.min(squaredDistance, 1 / lobe);
        return (25.0 / 16 * square(0.4 * squared - 1) - 9.0 / 16) * square(lobe * squared - 1);
    }

    private static double square(double value) {
        return value * value;
    }
}
