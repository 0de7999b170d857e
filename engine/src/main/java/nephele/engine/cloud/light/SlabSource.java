package nephele.engine.cloud.light;

/**
 * The diffuse light inside a slab that a beam meets, I₀ + µ I₁ in Eddington's approximation (Shettle and Weinman 1970,
 * "The Transfer of Solar Irradiance Through Inhomogeneous Turbid Atmospheres Evaluated by Eddington's Approximation",
 * equations 4 to 12), with no diffuse light from outside. Per unit irradiance normal to the beam; all depths are of the
 * scaled medium, along the normal of the slab. Not for several threads.
 */
final class SlabSource {
    private static final double BEAM = 1 / (4 * Math.PI);
    private static final double MARSHAK = 2.0 / 3;

    private final double albedo;
    private final double absorbed;
    private final double straightened;
    private final double g;
    private double mean;
    private double slope;

    SlabSource(CloudOptics optics) {
        albedo = optics.scaledAlbedo();
        g = optics.scaledCosine();
        absorbed = 1 - albedo;
        straightened = 1 - albedo * g;
    }

    /**
     * Finds the light at a depth of a slab.
     *
     * @param cosine between the beam and the normal, above 0
     */
    void find(double depth, double thickness, double cosine) {
        if (absorbed < 1e-6) {
            conserve(depth, thickness, cosine);
        } else {
            absorb(depth, thickness, cosine);
        }
    }

    private void conserve(double depth, double thickness, double mu) {
        double through = Math.exp(-thickness / mu);
        double c = BEAM * mu * (3 * mu + 2 + (2 - 3 * mu) * through) / (2 * MARSHAK + (1 - g) * thickness);
        double beam = Math.exp(-depth / mu);
        mean = 3 * mu * mu * BEAM * (1 - beam) + 2 * mu * BEAM - MARSHAK * c - (1 - g) * c * depth;
        slope = c - 3 * mu * BEAM * beam;
    }

    private void absorb(double depth, double thickness, double cosine) {
        double k = Math.sqrt(3 * absorbed * straightened);
        // The particular solution is singular at k µ = 1, where the general one makes up for it.
        double mu = Math.abs(1 - k * cosine) < 1e-3 ? cosine * 0.998 : cosine;
        double a = -3 * mu * mu * albedo * BEAM * (straightened + g) / (1 - k * k * mu * mu);
        double b = 3 * mu * (absorbed * a - albedo * BEAM);
        double p = k / straightened;
        double through = Math.exp(-thickness / mu);
        double fade = Math.exp(-k * thickness);
        double out = 1 + MARSHAK * p;
        double in = (1 - MARSHAK * p) * fade;
        double top = -a - MARSHAK * b;
        double bottom = -(a - MARSHAK * b) * through;
        double determinant = out * out - in * in;
        double falling = (top * out - in * bottom) / determinant;
        double rising = (out * bottom - in * top) / determinant;
        double beam = Math.exp(-depth / mu);
        double down = falling * Math.exp(-k * depth);
        double up = rising * Math.exp(-k * (thickness - depth));
        mean = down + up + a * beam;
        slope = p * (down - up) + b * beam;
    }

    /** Returns I₀. */
    double mean() {
        return mean;
    }

    /** Returns I₁; positive if more light travels with the beam than against it. */
    double slope() {
        return slope;
    }

    /** Returns the diffuse flux out of the lit side, divided by the beam's flux through it. */
    double reflected(double thickness, double cosine) {
        find(0, thickness, cosine);
        return Math.PI * (mean - MARSHAK * slope) / cosine;
    }

    /** Returns the diffuse flux out of the far side, divided by the beam's flux through the lit one. */
    double transmitted(double thickness, double cosine) {
        find(thickness, thickness, cosine);
        return Math.PI * (mean + MARSHAK * slope) / cosine;
    }
}
