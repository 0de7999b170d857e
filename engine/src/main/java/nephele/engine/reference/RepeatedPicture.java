package nephele.engine.reference;

import java.util.Arrays;
import nephele.engine.asset.Picture;
import nephele.engine.level.appearance.ColourDecoding;

/** A picture that repeats in both directions, interpolated bilinearly between its pixel centres, in linear values. */
final class RepeatedPicture {
    private final Picture picture;
    private final double[] linear;

    RepeatedPicture(Picture picture, ColourDecoding decoding) {
        this.picture = picture.toRgba8();
        linear = decoding.table();
    }

    /**
     * Writes red, green, blue and alpha (never decoded) at texture coordinates.
     *
     * @param t 0 at the top row, growing downwards
     */
    void read(double s, double t, double[] rgba) {
        double x = (s - Math.floor(s)) * picture.width() - 0.5;
        double y = (t - Math.floor(t)) * picture.height() - 0.5;
        int left = (int) Math.floor(x);
        int top = (int) Math.floor(y);
        double fx = x - left;
        double fy = y - top;
        int right = left + 1 == picture.width() ? 0 : left + 1;
        int bottom = top + 1 == picture.height() ? 0 : top + 1;
        left = left < 0 ? picture.width() - 1 : left;
        top = top < 0 ? picture.height() - 1 : top;
        Arrays.fill(rgba, 0);
        add(left, top, (1 - fx) * (1 - fy), rgba);
        add(right, top, fx * (1 - fy), rgba);
        add(left, bottom, (1 - fx) * fy, rgba);
        add(right, bottom, fx * fy, rgba);
    }

    private void add(int column, int row, double weight, double[] rgba) {
        byte[] samples = picture.samples();
        int at = 4 * (row * picture.width() + column);
        for (int channel = 0; channel < 3; channel++) {
            rgba[channel] += weight * linear[samples[at + channel] & 0xff];
        }
        rgba[3] += weight * ((samples[at + 3] & 0xff) / 255.0);
    }
}
