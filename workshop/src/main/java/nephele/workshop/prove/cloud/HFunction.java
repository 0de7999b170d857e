package nephele.workshop.prove.cloud;

/**
 * The H function of a semi-infinite medium that scatters isotropically. S. Chandrasekhar, "Radiative Transfer", 1950,
 * section 39: ln H(μ) = −(μ/π) ∫ ln(1 − ϖ t cot t) / (cos² t + μ² sin² t) dt from 0 to π/2.
 *
 * @param albedo ϖ, 0 to 1
 */
record HFunction(double albedo) {
    private static final int STEPS = 20_000;

    /** Returns H at the cosine of an angle from the normal, by the midpoint rule; errors are below 1e-7. */
    double at(double mu) {
        double sum = 0;
        for (int i = 0; i < STEPS; i++) {
            double u = (i + 0.5) / STEPS;
            // The cube brings the nodes close together at the logarithmic singularity of albedo 1.
            double t = Math.PI / 2 * u * u * u;
            double weight = Math.PI / 2 * 3 * u * u / STEPS;
            double cosine = Math.cos(t);
            double sine = Math.sin(t);
            sum += weight * Math.log(escaping(t, cosine / sine)) / (cosine * cosine + mu * mu * sine * sine);
        }
        return Math.exp(-mu / Math.PI * sum);
    }

    /** Returns 1 − ϖ t cot t; near 0 by its series, as digits would cancel. */
    private double escaping(double t, double cotangent) {
        double absorbed = 1 - albedo;
        return t < 1e-2
                ? absorbed + albedo * t * t * (1.0 / 3 + t * t * (1.0 / 45 + t * t * 2.0 / 945))
                : 1 - albedo * t * cotangent;
    }

    /** Returns the reflected radiance by the irradiance on a plane perpendicular to the beam. */
    double reflected(double mu, double mu0) {
        return albedo / (4 * Math.PI) * mu0 / (mu + mu0) * at(mu) * at(mu0);
    }
}
