package nephele.engine.render.resource;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.asset.Picture;
import nephele.engine.level.appearance.ColourDecoding;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ResampledPictureTest {
    private static Picture noise(int width, int height, int least, int most) {
        byte[] samples = new byte[4 * width * height];
        SplittableRandom random = new SplittableRandom(4);
        for (int i = 0; i < samples.length; i++) {
            samples[i] = (byte) random.nextInt(least, most + 1);
        }
        return new Picture(width, height, 4, 8, samples);
    }

    private static double mean(byte[] rgba, int channel, double[] linear) {
        double sum = 0;
        for (int i = channel; i < rgba.length; i += 4) {
            sum += linear[rgba[i] & 0xff];
        }
        return sum / (rgba.length / 4);
    }

    /** Rounding averages out over many texels; that of the last levels is at most half a code. */
    @ParameterizedTest
    @CsvSource({"64, 64, 0, 255", "64, 64, 10, 24", "48, 20, 90, 200", "33, 7, 0, 255", "1, 9, 0, 255"})
    void noLevelIsBrighterOrDarker(int width, int height, int least, int most) {
        Picture picture = noise(width, height, least, most);
        double[] linear = ColourDecoding.SRGB.table();
        List<byte[]> levels = ResampledPicture.mipLevels(picture, ColourDecoding.SRGB);
        assertEquals(4, levels.get(levels.size() - 1).length, "the last is a single texel");
        for (int channel = 0; channel < 3; channel++) {
            double whole = mean(picture.samples(), channel, linear);
            int code = 0;
            while (linear[code + 1] < whole) {
                code++;
            }
            double halfCode = 0.51 * (linear[code + 1] - linear[code]);
            for (byte[] level : levels) {
                double texels = level.length / 4.0;
                double bound = Math.max(4 * halfCode / Math.sqrt(texels), 1e-4);
                assertEquals(whole, mean(level, channel, linear), Math.min(bound, 1.2 * halfCode), texels + " texels");
            }
        }
    }

    @Test
    void aPlainPictureStaysWhatItIs() {
        for (ColourDecoding decoding : ColourDecoding.values()) {
            for (int code = 0; code < 256; code++) {
                Picture picture = noise(5, 3, code, code);
                for (byte[] level : ResampledPicture.mipLevels(picture, decoding)) {
                    for (byte value : level) {
                        assertEquals(code, value & 0xff);
                    }
                }
            }
        }
    }
}
