package nephele.host.compare;

import java.util.Locale;
import nephele.engine.level.Environment;
import nephele.engine.level.appearance.AutoExposure;
import nephele.engine.measure.Flip;
import nephele.engine.measure.ImageError;
import nephele.engine.measure.LinearPicture;
import nephele.engine.render.frame.ToneMapping;

/**
 * The difference of a picture from its reference, both shown at the reference's exposure.
 *
 * @param flip mean FLIP (Andersson et al. 2020) of the displayed pictures, 0 to 1
 * @param lightExcess mean radiance relative to the reference's, minus 1
 */
public record PictureDifference(double flip, double lightExcess) {
    /** The greatest half float; what is brighter counts as this. */
    private static final float BRIGHTEST = 65504;

    /** Returns true if nothing would be seen: each rounds to 0 in the digits that are told, 0.001 and 0.1 %. */
    public boolean isNone() {
        return flip < 5e-4 && Math.abs(lightExcess) < 5e-4;
    }

    /** Returns the difference of light in per cent with its sign, such as {@code +2.4}, and {@code 0.0} for none. */
    public String lightPercent() {
        String digits = String.format(Locale.ROOT, "%.1f", Math.abs(100 * lightExcess));
        String sign = digits.equals("0.0") ? "" : lightExcess < 0 ? "−" : "+";
        return sign + digits;
    }

    /**
     * Measures linear radiances, RGB, of the same size.
     *
     * @param environment has exposure and tone curve
     */
    static PictureDifference of(float[] reference, float[] tried, int width, Environment environment) {
        int height = reference.length / 3 / width;
        LinearPicture exact = finite(reference, width, height);
        LinearPicture other = finite(tried, width, height);
        double exposure = Math.pow(2, AutoExposure.stops(environment, exact.rgb(), width));
        double flip = Flip.ofDisplayed(displayed(exact, exposure, environment), displayed(other, exposure, environment))
                .mean();
        return new PictureDifference(flip, ImageError.meanBias(exact, other));
    }

    private static LinearPicture finite(float[] rgb, int width, int height) {
        float[] finite = new float[rgb.length];
        for (int i = 0; i < rgb.length; i++) {
            finite[i] = rgb[i] > 0 ? Math.min(rgb[i], BRIGHTEST) : 0;
        }
        return new LinearPicture(width, height, finite);
    }

    private static LinearPicture displayed(LinearPicture radiance, double exposure, Environment environment) {
        float[] displayed = new float[radiance.rgb().length];
        for (int i = 0; i < displayed.length; i++) {
            displayed[i] = (float) ToneMapping.toneCurve(exposure * radiance.rgb()[i], environment.toneCurve());
        }
        return new LinearPicture(radiance.width(), radiance.height(), displayed);
    }
}
