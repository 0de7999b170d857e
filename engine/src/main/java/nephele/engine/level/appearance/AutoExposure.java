package nephele.engine.level.appearance;

import nephele.engine.level.Environment;

/**
 * The exposure of {@code "auto"}: what a picture calls for, and how the eye's adaption approaches that in simulated time.
 * The twin of {@code adapt.frag}.
 *
 * <p>Exposure brings the metered luminance to a share of {@link #key}, the automatic key of G. Krawczyk, K. Myszkowski
 * and H.-P. Seidel, "Perceptual Effects in Real-time Tone Mapping", 2005: what is dark is shown darker, so that night
 * looks like night.
 */
public final class AutoExposure {
    /** Shows the largest half float as white. */
    public static final double LEAST_STOPS = -16;

    /** With more, the smallest steps of half floats would be visible. */
    public static final double MOST_STOPS = 12;

    /** Adaption to the dark: the share 1 − 1/e of the way in a second. */
    public static final double BRIGHTENING_PER_SECOND = 1;

    /** Adaption to light, which is faster in the eye too. */
    public static final double DARKENING_PER_SECOND = 3;

    /** Displayed linear value of the metered luminance, relative to the key: 0.27 in daylight, as lit things are metered. */
    public static final double DISPLAYED_PER_KEY = 0.4;

    /**
     * The luminance in cd/m² that radiance 1 stands for in the key. A sun of irradiance 4 would mean 30 000; less than
     * that is right for the levels' nights, which are brighter than nature's.
     */
    public static final double CANDELAS_PER_SQUARE_METRE = 10_000;

    private static final double LOG_2 = Math.log(2);

    private AutoExposure() {}

    /** Returns the key of a metered log2 luminance: from 0.03 in the dark to 0.7 in the sun. */
    public static double key(double log2) {
        return 1.03 - 2 / (2 + Math.log10(CANDELAS_PER_SQUARE_METRE * Math.pow(2, log2) + 1));
    }

    /**
     * Returns the stops that a picture calls for; the greatest for a black one.
     *
     * @param heldStops the stops for a picture without light of which a part is hidden
     */
    public static double stops(LuminanceHistogram picture, double heldStops) {
        double log2 = picture.meanLog2();
        if (Double.isNaN(log2)) {
            return picture.hasHidden() ? heldStops : MOST_STOPS;
        }
        double stops = Math.log(DISPLAYED_PER_KEY * key(log2)) / LOG_2 - log2;
        return Math.min(Math.max(stops, LEAST_STOPS), MOST_STOPS);
    }

    /**
     * Returns the stops of a picture without history: those that the environment says, or that the picture calls for.
     *
     * @param rgb linear radiance
     */
    public static double stops(Environment environment, float[] rgb, int width) {
        return environment.exposureStops().isAuto()
                ? stops(LuminanceHistogram.of(rgb, width), MOST_STOPS)
                : environment.exposureStops().fixedStops();
    }

    /** Returns the stops after some simulated time of adaption to a picture that calls for {@code target}. */
    public static double adapted(double stops, double target, double seconds) {
        double perSecond = target > stops ? BRIGHTENING_PER_SECOND : DARKENING_PER_SECOND;
        return stops + approach(perSecond, seconds) * (target - stops);
    }

    /** Returns the share of the way in some time; many short steps make one long one. */
    public static double approach(double perSecond, double seconds) {
        return -Math.expm1(-perSecond * seconds);
    }
}
