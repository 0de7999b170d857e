package nephele.workshop.prove.picture;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import nephele.engine.measure.ColourVision;

/**
 * How far a sign stands out from what is around it: the difference of L* from the median within two degrees that a quarter
 * of the sign's pixels reach, for each colour vision. The sign is where a picture differs from one without it.
 */
final class SignContrast {
    /** A smaller difference of a channel, 0–255, is no sign but its light on something else. */
    private static final int LEAST_CODES = 6;

    /** A sign of fewer pixels, as a fraction of the square of its reach, is mostly hidden. */
    private static final double LEAST_SHARE = 0.1;

    private static final double REACHED_SHARE = 0.25;

    private final int width;
    private final int height;
    private final double aroundPixels;

    /** @param aroundPixels two degrees, in pixels */
    SignContrast(int width, int height, double aroundPixels) {
        this.width = width;
        this.height = height;
        this.aroundPixels = aroundPixels;
    }

    /**
     * Returns the difference of L* by the ordinal of the {@link ColourVision}; {@code null} if most of the sign is hidden.
     *
     * @param centreX where the sign is, in pixels
     * @param reach beyond which changes belong to other signs, in pixels
     */
    double[] of(BufferedImage with, BufferedImage without, double centreX, double centreY, double reach) {
        boolean[] sign = new boolean[width * height];
        int count = 0;
        for (int i = 0; i < sign.length; i++) {
            int x = i % width;
            int y = i / width;
            sign[i] = Math.hypot(x - centreX, y - centreY) < reach && differs(with.getRGB(x, y), without.getRGB(x, y));
            count += sign[i] ? 1 : 0;
        }
        return count < LEAST_SHARE * reach * reach ? null : contrasts(with, sign, around(sign));
    }

    private double[] contrasts(BufferedImage picture, boolean[] sign, boolean[] around) {
        double[] contrasts = new double[ColourVision.values().length];
        for (ColourVision vision : ColourVision.values()) {
            double[] there = lightness(picture, vision, around);
            double median = there[there.length / 2];
            double[] off = lightness(picture, vision, sign);
            for (int i = 0; i < off.length; i++) {
                off[i] = Math.abs(off[i] - median);
            }
            Arrays.sort(off);
            contrasts[vision.ordinal()] = off[(int) ((1 - REACHED_SHARE) * (off.length - 1))];
        }
        return contrasts;
    }

    /** Returns the sorted L* of some pixels. */
    private double[] lightness(BufferedImage picture, ColourVision vision, boolean[] of) {
        double[] all = new double[of.length];
        int count = 0;
        for (int i = 0; i < of.length; i++) {
            if (of[i]) {
                int rgb = picture.getRGB(i % width, i / width);
                all[count++] = vision.lightness(linear(rgb >> 16 & 255), linear(rgb >> 8 & 255), linear(rgb & 255));
            }
        }
        double[] sorted = Arrays.copyOf(all, count);
        Arrays.sort(sorted);
        return sorted;
    }

    private boolean[] around(boolean[] sign) {
        boolean[] around = new boolean[sign.length];
        int most = (int) Math.ceil(aroundPixels);
        for (int i = 0; i < sign.length; i++) {
            if (!sign[i]) {
                continue;
            }
            int x = i % width;
            int y = i / width;
            for (int row = Math.max(0, y - most); row <= Math.min(height - 1, y + most); row++) {
                double square = aroundPixels * aroundPixels - (row - y) * (row - y);
                int half = square < 0 ? -1 : (int) Math.sqrt(square);
                for (int column = Math.max(0, x - half); column <= Math.min(width - 1, x + half); column++) {
                    around[row * width + column] |= !sign[row * width + column];
                }
            }
        }
        return around;
    }

    private static boolean differs(int one, int other) {
        return Math.abs((one >> 16 & 255) - (other >> 16 & 255)) >= LEAST_CODES
                || Math.abs((one >> 8 & 255) - (other >> 8 & 255)) >= LEAST_CODES
                || Math.abs((one & 255) - (other & 255)) >= LEAST_CODES;
    }

    /** Decodes sRGB, IEC 61966-2-1. */
    private static double linear(int code) {
        double value = code / 255.0;
        return value <= 0.04045 ? value / 12.92 : Math.pow((value + 0.055) / 1.055, 2.4);
    }
}
