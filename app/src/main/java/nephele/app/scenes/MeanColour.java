package nephele.app.scenes;

import nephele.engine.asset.Picture;
import nephele.engine.level.appearance.Decoding;
import nephele.engine.math.Vec3;

/** What a picture looks like from far away. */
final class MeanColour {
    private static final double[] LINEAR = Decoding.SRGB.table();

    private MeanColour() {}

    /** In linear light. */
    static Vec3 of(Picture picture) {
        byte[] rgba = picture.toRgba8().samples();
        double[] sums = new double[3];
        for (int i = 0; i < rgba.length; i += 4) {
            for (int channel = 0; channel < 3; channel++) {
                sums[channel] += LINEAR[rgba[i + channel] & 0xff];
            }
        }
        double pixels = rgba.length / 4.0;
        return new Vec3(sums[0] / pixels, sums[1] / pixels, sums[2] / pixels);
    }
}
