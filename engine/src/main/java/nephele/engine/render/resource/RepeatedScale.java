package nephele.engine.render.resource;

import nephele.engine.asset.Picture;
import nephele.engine.level.appearance.ColourDecoding;

/** Enlarges pictures that repeat: bilinear in linear values, across their edges, rounded once. */
public final class RepeatedScale {
    private final Picture from;
    private final ColourDecoding.Codes codes;

    private RepeatedScale(Picture from, ColourDecoding decoding) {
        this.from = from;
        codes = decoding.codes();
    }

    /**
     * Returns a picture with this many pixels.
     *
     * @param picture 8-bit RGBA, not larger; alpha is linear
     */
    public static Picture of(Picture picture, int width, int height, ColourDecoding decoding) {
        if (picture.width() == width && picture.height() == height) {
            return picture;
        }
        RepeatedScale colours = new RepeatedScale(picture, decoding);
        RepeatedScale alphas = new RepeatedScale(picture, ColourDecoding.AS_STORED);
        byte[] samples = new byte[4 * width * height];
        for (int y = 0, at = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                double fromX = (x + 0.5) / width * picture.width() - 0.5;
                double fromY = (y + 0.5) / height * picture.height() - 0.5;
                for (int channel = 0; channel < 4; channel++, at++) {
                    samples[at] = (channel == 3 ? alphas : colours).code(fromX, fromY, channel);
                }
            }
        }
        return new Picture(width, height, 4, 8, samples);
    }

    private byte code(double x, double y, int channel) {
        int left = (int) Math.floor(x);
        int top = (int) Math.floor(y);
        double upper = mix(at(left, top, channel), at(left + 1, top, channel), x - left);
        double lower = mix(at(left, top + 1, channel), at(left + 1, top + 1, channel), x - left);
        return codes.nearest(mix(upper, lower, y - top));
    }

    private double at(int x, int y, int channel) {
        int column = Math.floorMod(x, from.width());
        return codes.linear((byte) from.sample(column, Math.floorMod(y, from.height()), channel));
    }

    private static double mix(double a, double b, double share) {
        return a + share * (b - a);
    }
}
