package nephele.engine.render;

import java.awt.image.BufferedImage;
import nephele.engine.level.Environment;
import nephele.engine.level.appearance.AutoExposure;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.ToneMapping;

/** Converts linear radiance to the picture that the engine's own tone mapping gives. */
public final class ToneMappedPicture {
    private ToneMappedPicture() {}

    /**
     * Returns the displayed picture; exposure auto is metered from it.
     *
     * @param rgb linear radiance, the bottom row first
     */
    public static BufferedImage of(float[] rgb, int width, Environment environment, Output output) {
        int height = rgb.length / 3 / width;
        double exposure = Math.pow(2, AutoExposure.stops(environment, rgb, width));
        var image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int code = 0;
                double dither = output == Output.PLAIN ? 0 : ToneMapping.ditherOffset(x, y);
                for (int channel = 0; channel < 3; channel++) {
                    double radiance = rgb[3 * (y * width + x) + channel];
                    double shown = output == Output.PLAIN
                            ? radiance
                            : ToneMapping.displayValue(radiance, exposure, environment.toneCurve());
                    code = code << 8 | (int) Math.rint(Math.min(Math.max(255 * shown + dither, 0), 255));
                }
                image.setRGB(x, height - 1 - y, code);
            }
        }
        return image;
    }
}
