package nephele.engine.cloud;

/**
 * Light in a plane slab in the delta-Eddington approximation, in closed form (Joseph, Wiscombe and Weinman 1976; Meador
 * and Weaver 1980, "Two-Stream Approximations to Radiative Transfer in Planetary Atmospheres", whose γ1 + γ2 is a and γ1
 * − γ2 is b here). With S the sum of the fluxes up and down, N their net flux down, t the scaled optical depth and m =
 * 1/μ₀:
 *
 * <pre>
 * S' = −a N + 3/2 ωg e^(−mt),   N' = −b S + ωm e^(−mt),   a = 3/2 (1 − ωg),   b = 2 (1 − ω),   k² = ab
 * S = A e^(−kt) + B v(t) + p(t),   v = e^(−kτ) sinh(kt)/k,   p = c/(m + k) · (e^(−kt) − e^(−mt))/(m − k)
 * </pre>
 *
 * <p>In this basis nothing overflows in a deep slab, and nothing is divided by 0 where the albedo is 1 (k = 0) or where
 * kμ₀ = 1. Fluxes are in units of the incident flux through the slab's plane.
 */
public final class TwoStreamSlab {
    /** Lower bound of the cosine of the incident beam. */
    private static final double LEAST_COSINE = 1e-6;

    /** Below it {@link #exponentialMean} is a series, because the difference cancels, and so must a shader's be. */
    static final double SERIES_BELOW = 1e-3;

    private final DeltaScaling medium;
    private final double depth;
    private final double a;
    private final double k;
    /** The beam's m, c/(m + k) and 3/2 ωg. */
    private final double m;

    private final double source;
    private final double forward;
    private final double fromTop;
    private final double fromBottom;

    private TwoStreamSlab(DeltaScaling medium, double opticalDepth, double cosine) {
        this.medium = medium;
        depth = medium.depthFactor() * opticalDepth;
        double albedo = medium.albedo();
        a = 1.5 * (1 - albedo * medium.g());
        k = Math.sqrt(2 * (1 - albedo) * a);
        m = 1 / Math.max(LEAST_COSINE, cosine);
        forward = 1.5 * albedo * medium.g();
        source = 1.5 * albedo * m * (1 - albedo * medium.g() + medium.g()) / (m + k);
        double atTop = source - forward;
        double atBottom = forward * Math.exp(-m * depth) - a * particular(depth) - particularSlope(depth);
        double through = Math.exp(-k * depth);
        double deep = a * rising(depth) + risingSlope(depth);
        double determinant = (a + k) * deep + (a - k) * through * through;
        fromTop = (atTop * deep + through * atBottom) / determinant;
        fromBottom = ((a + k) * atBottom - (a - k) * through * atTop) / determinant;
    }

    /**
     * Returns a slab under a parallel beam.
     *
     * @param opticalDepth of the slab along its normal, not scaled
     * @param cosine of the angle between beam and normal, 0 to 1; less than 1e-6 counts as that
     */
    public static TwoStreamSlab underBeam(DeltaScaling medium, double opticalDepth, double cosine) {
        return new TwoStreamSlab(medium, opticalDepth, cosine);
    }

    /** Returns the fraction that leaves the slab at its top. */
    public double reflectance() {
        return Math.max(0, fromTop);
    }

    /** Returns the fraction that leaves the slab below, unscattered light included. */
    public double transmittance() {
        return Math.max(0, sum(depth)) + beam(depth);
    }

    /**
     * Returns the diffuse fluence at a depth: the radiance integrated over all directions, without the part of the beam
     * that is unscattered or in the forward peak.
     *
     * @param opticalDepth below the top, along the normal, not scaled
     */
    public double diffuseFluence(double opticalDepth) {
        return 2 * sum(Math.min(depth, medium.depthFactor() * opticalDepth));
    }

    /**
     * Returns the net flux down of diffuse light at a depth: down minus up, without what is unscattered or in the forward
     * peak.
     *
     * @param opticalDepth below the top, along the normal, not scaled
     */
    public double diffuseNetFlux(double opticalDepth) {
        double at = Math.min(depth, medium.depthFactor() * opticalDepth);
        double slope = -k * fromTop * Math.exp(-k * at) + fromBottom * risingSlope(at) + particularSlope(at);
        return (forward * Math.exp(-m * at) - slope) / a;
    }

    /**
     * Returns I₀ of the diffuse radiance I₀ + µ I₁ at a depth, µ the cosine with the direction down.
     *
     * @param opticalDepth below the top, along the normal, not scaled
     */
    public double diffuseMean(double opticalDepth) {
        return diffuseFluence(opticalDepth) / (4 * Math.PI);
    }

    /** Returns I₁ of the diffuse radiance I₀ + µ I₁ at a depth below the top, not scaled. */
    public double diffuseSlope(double opticalDepth) {
        return 3 * diffuseNetFlux(opticalDepth) / (4 * Math.PI);
    }

    private double beam(double at) {
        return Math.exp(-m * at);
    }

    private double sum(double at) {
        return fromTop * Math.exp(-k * at) + fromBottom * rising(at) + particular(at);
    }

    /** Returns e^(−kτ) sinh(kt)/k. */
    private double rising(double at) {
        return Math.exp(-k * (depth - at)) * at * exponentialMean(2 * k * at);
    }

    private double risingSlope(double at) {
        return (Math.exp(-k * (depth - at)) + Math.exp(-k * (depth + at))) / 2;
    }

    private double particular(double at) {
        return source * difference(at);
    }

    private double particularSlope(double at) {
        return source * (Math.exp(-m * at) - k * difference(at));
    }

    /** Returns (e^(−kt) − e^(−mt))/(m − k). */
    private double difference(double at) {
        double slower = Math.min(k, m);
        return Math.exp(-slower * at) * at * exponentialMean(Math.abs(m - k) * at);
    }

    /**
     * Returns the mean of e^(−t) for t from 0 to x, (1 − e^(−x))/x, with a relative error below 1e-12. A step of optical
     * depth x through a medium of even source has this part of its thin-layer radiance.
     *
     * @param x at least 0; may be infinite
     */
    static double exponentialMean(double x) {
        return x < SERIES_BELOW ? 1 - x / 2 * (1 - x / 3 * (1 - x / 4)) : (1 - Math.exp(-x)) / x;
    }
}
