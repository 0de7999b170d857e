package nephele.engine.cloud;

/**
 * A scattering medium whose forward peak counts as unscattered light (Joseph, Wiscombe and Weinman 1976, "The
 * Delta-Eddington Approximation for Radiative Flux Transfer", equations 5 and 13): a fraction f = g² of the scattered light
 * goes straight on. A medium that scatters backwards has no such peak and stays as it is, but that its asymmetry counts as
 * at least −⅔: beyond, the approximation reflects more than there is.
 *
 * @param depthFactor scaled optical depth divided by the medium's own
 * @param albedo of the scaled medium
 * @param g of the scaled medium, −⅔ to ½
 */
public record DeltaScaling(double depthFactor, double albedo, double g) {
    private static final double LEAST_G = -2.0 / 3;

    /**
     * Returns the scaled medium.
     *
     * @param albedo 0 to 1
     * @param g mean cosine of the scattering angle, −1 to 1
     * @param forwardFraction f, the fraction of scattered light that goes straight on, 0 to 1
     */
    public static DeltaScaling of(double albedo, double g, double forwardFraction) {
        if (!(albedo >= 0 && albedo <= 1 && g >= -1 && g <= 1)) {
            throw new IllegalArgumentException("albedo " + albedo + " or asymmetry " + g + " is out of range");
        }
        double factor = 1 - albedo * forwardFraction;
        // Where everything goes straight on, nothing is left that scatters.
        double scattered = factor > 0 ? albedo * (1 - forwardFraction) / factor : 0;
        double rest = forwardFraction < 1 ? (g - forwardFraction) / (1 - forwardFraction) : 0;
        return new DeltaScaling(factor, Math.min(1, scattered), Math.max(LEAST_G, rest));
    }
}
