package nephele.lab.trade.subject;

import java.nio.ByteBuffer;
import java.util.stream.IntStream;
import nephele.engine.measure.LinearPicture;
import nephele.engine.render.frame.ToneMapping;

/** The light that a display emits for 8-bit codes. */
final class DisplayedLight {
    /** Linear light of each sRGB code. */
    private static final double[] LIGHT = IntStream.range(0, 256)
            .mapToDouble(code -> ToneMapping.decodeSrgb(code / 255.0))
            .toArray();

    private DisplayedLight() {}

    /**
     * Returns the mean linear light of boxes of {@code side} by {@code side} pixels.
     *
     * @param rgba the codes, four a pixel, row by row
     * @param width of the result
     * @param height of the result
     */
    static LinearPicture of(ByteBuffer rgba, int width, int height, int side) {
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < rgb.length; i++) {
            int column = i / 3 % width;
            int row = i / 3 / width;
            double sum = 0;
            for (int y = row * side; y < (row + 1) * side; y++) {
                for (int x = column * side; x < (column + 1) * side; x++) {
                    sum += LIGHT[rgba.get(4 * (y * width * side + x) + i % 3) & 0xff];
                }
            }
            rgb[i] = (float) (sum / (side * side));
        }
        return new LinearPicture(width, height, rgb);
    }
}
