package nephele.lab.bake;

import java.util.Locale;

/**
 * The loss of linear radiance in pictures of 8 bits.
 *
 * @param white radiance of the greatest code
 * @param clipped pixels of which a channel is above white
 * @param dark pixels of which no channel reaches the first code
 * @param brightest channel
 * @param lost fraction of the light that is above white
 */
public record EightBitLoss(double white, int pixels, int clipped, int dark, double brightest, double lost) {
    /** The radiance whose code is 1, as a fraction of white. */
    static final double FIRST_CODE = 1 / (255 * 12.92);

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
