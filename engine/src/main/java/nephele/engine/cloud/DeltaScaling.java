package nephele.engine.cloud;

/**
 * A scattering medium whose forward peak counts as unscattered light (Joseph, Wiscombe and Weinman 1976, "The
 * Delta-Eddington Approximation for Radiative Flux Transfer", equations 5 and 13): a share f = g² of the scattered light
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
     * @param g −1 to 1
     */
    public static DeltaScaling of(double albedo, double g) {
        if (!(albedo >= 0 && albedo <= 1 && g >= -1 && g <= 1)) {
            throw new IllegalArgumentException("albedo " + albedo + " or asymmetry " + g + " is out of range");
        }
        double forward = g > 0 ? g * g : 0;
        double factor = 1 - albedo * forward;
        // Where everything goes straight on, nothing is left that scatters.
        double scattered = factor > 0 ? albedo * (1 - forward) / factor : 0;
        return new DeltaScaling(factor, Math.min(1, scattered), g > 0 ? g / (1 + g) : Math.max(LEAST_G, g));
    }
}
