package nephele.engine.measure;

import java.util.stream.IntStream;

/** FLIP of radiance: the greatest of its errors under a range of exposures (Andersson et al. 2021). */
public final class HdrFlip {
    private HdrFlip() {}

    /** Under the exposures that the reference asks for. */
    public static ErrorMap of(LinearPicture reference, LinearPicture test) {
        return of(reference, test, ExposureRange.of(reference));
    }

    /** Under given exposures, so that a series of references can be compared. */
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
            rgb[i] = (float) ToneCurve.map(exposure * Math.max(rgb[i], 0));
        }
        return new LinearPicture(radiance.width(), radiance.height(), rgb);
    }
}
