package nephele.editor.proving;

import java.awt.image.BufferedImage;
import nephele.engine.asset.Picture;
import nephele.engine.level.Level;
import nephele.engine.render.ToneMappedPicture;
import nephele.host.draw.Outputs;

/** The mean of traced pictures, weighted by their samples. */
final class TraceProgress {
    private final int width;
    private final double[] sum;
    private int samples;

    TraceProgress(int width, int height) {
        this.width = width;
        sum = new double[3 * width * height];
    }

    int samples() {
        return samples;
    }

    void add(float[] radiance, int itsSamples) {
        for (int i = 0; i < sum.length; i++) {
            sum[i] += (double) radiance[i] * itsSamples;
        }
        samples += itsSamples;
    }

    Picture picture(Level level) {
        float[] mean = new float[sum.length];
        for (int i = 0; i < sum.length; i++) {
            mean[i] = (float) (sum[i] / samples);
        }
        return picture(mean, width, level);
    }

    /** Returns radiance, the bottom row first, as the engine would display it. */
    static Picture picture(float[] radiance, int width, Level level) {
        BufferedImage image = ToneMappedPicture.of(radiance, width, level.environment(), Outputs.defaultFor(level));
        byte[] rgb = new byte[3 * width * image.getHeight()];
        for (int i = 0; i < width * image.getHeight(); i++) {
            int colour = image.getRGB(i % width, i / width);
            rgb[3 * i] = (byte) (colour >> 16);
            rgb[3 * i + 1] = (byte) (colour >> 8);
            rgb[3 * i + 2] = (byte) colour;
        }
        return new Picture(width, image.getHeight(), 3, 8, rgb);
    }
}
