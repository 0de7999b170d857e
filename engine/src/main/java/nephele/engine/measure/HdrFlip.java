package nephele.engine.measure;

import java.util.stream.IntStream;

/** FLIP of radiance: the maximum of its errors over a range of exposures (Andersson et al. 2021). */
public final class HdrFlip {
    private HdrFlip() {}

    /** Returns the error of each pixel over the exposures of the reference. */
    public static ErrorMap of(LinearPicture reference, LinearPicture test) {
        return of(reference, test, ExposureRange.of(reference));
    }

    /** Returns the error of each pixel over given exposures, so that several references can be compared. */
    public static ErrorMap of(LinearPicture reference, LinearPicture test, ExposureRange exposures) {
        reference.requireSameSize(test);
        return IntStream.range(0, exposures.count())
                .parallel()
                .mapToObj(i -> Flip.ofDisplayed(shown(reference, exposures.stops(i)), shown(test, exposures.stops(i))))
                .reduce(ErrorMap::greater)
                .orElseThrow();
    }

    private static LinearPicture shown(LinearPicture radiance, double stops) {
        double exposure = Math.pow(2, stops);
        float[] rgb = radiance.rgb().clone();
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = (float) DisplayToneCurve.map(exposure * Math.max(rgb[i], 0));
        }
        return new LinearPicture(radiance.width(), radiance.height(), rgb);
    }
}
