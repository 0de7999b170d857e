package nephele.engine.reference;

import java.util.Arrays;
import nephele.engine.asset.Picture;
import nephele.engine.level.appearance.Decoding;

/** A picture that repeats in both directions, bilinear between the middles of its pixels, in linear values. */
final class RepeatedPicture {
    private final Picture picture;
    private final double[] linear;

    RepeatedPicture(Picture picture, Decoding decoding) {
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
        Arrays.fill(rgba, 0);
        add(left, top, (1 - fx) * (1 - fy), rgba);
        add(left + 1, top, fx * (1 - fy), rgba);
        add(left, top + 1, (1 - fx) * fy, rgba);
        add(left + 1, top + 1, fx * fy, rgba);
    }

    private void add(int column, int row, double weight, double[] rgba) {
        int x = Math.floorMod(column, picture.width());
        int y = Math.floorMod(row, picture.height());
        byte[] samples = picture.samples();
        int at = 4 * (y * picture.width() + x);
        for (int channel = 0; channel < 3; channel++) {
            rgba[channel] += weight * linear[samples[at + channel] & 0xff];
        }
        rgba[3] += weight * ((samples[at + 3] & 0xff) / 255.0);
    }
}
