package nephele.lab.bake;

import java.util.Locale;

/**
 * What pictures of 8 bits lose of linear radiance.
 *
 * @param white radiance of the greatest code
 * @param clipped pixels of which a channel is above white
 * @param dark pixels of which no channel reaches the first code
 * @param brightest channel
 * @param lost share of the light that is above white
 */
public record EightBitLoss(double white, int pixels, int clipped, int dark, double brightest, double lost) {
    /** The radiance whose code is 1, as a fraction of white. */
    private static final double FIRST_CODE = 1 / (255 * 12.92);

    /** Counts pixels. */
    static final class Tally {
        private final double white;
        private int pixels;
        private int clipped;
        private int dark;
        private double brightest;
        private double light;
        private double above;

        Tally(double white) {
            this.white = white;
        }

        /** @param steradians of the pixel, in any unit */
        void add(float[] rgb, int pixel, double steradians) {
            double most = 0;
            for (int at = 3 * pixel; at < 3 * pixel + 3; at++) {
                most = Math.max(most, rgb[at]);
                light += steradians * rgb[at];
                above += steradians * Math.max(0, rgb[at] - white);
            }
            pixels++;
            clipped += most > white ? 1 : 0;
            dark += most < FIRST_CODE * white ? 1 : 0;
            brightest = Math.max(brightest, most);
        }

        EightBitLoss loss() {
            return new EightBitLoss(white, pixels, clipped, dark, brightest, light > 0 ? above / light : 0);
        }
    }

    /** Says it in a line. */
    @Override
    public String toString() {
        return String.format(
                Locale.ROOT,
                "8 bits clip %,d of %,d pixels at %.3g (%.2f %%; the brightest has %.3g), %.2g %% of the sky's light;"
                        + " %.2f %% of the pixels are darker than the first code",
                clipped,
                pixels,
                white,
                100.0 * clipped / pixels,
                brightest,
                100 * lost,
                100.0 * dark / pixels);
    }
}
