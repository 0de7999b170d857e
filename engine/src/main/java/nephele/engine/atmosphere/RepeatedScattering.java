package nephele.engine.atmosphere;

import nephele.engine.math.GaussLegendre;

/** Light of a field that molecules and aerosols scatter once more, per metre. */
final class RepeatedScattering implements AirSource {
    /** Degree up to which the phase function of molecules has Legendre coefficients. */
    private static final int MOLECULES_DEGREE = 2;

    /** Fraction of the scattering by aerosols below which their higher degrees are neglected: from some 14 km on. */
    private static final double LEAST_AEROSOLS = 3e-5;

    private final Air air;
    private final LightField field;
    private final DirectionMoments harmonics;
    /** The Legendre coefficients of the aerosols' phase function, 1 for degree 0. */
    private final double[] mieMoments;

    private final double[] values;
    private final double[] weights;

    RepeatedScattering(Air air, LightField field, double[] mieMoments) {
        this.air = air;
        this.field = field;
        this.mieMoments = mieMoments;
        harmonics = new DirectionMoments(field.degree());
        values = new double[DirectionMoments.count(field.degree())];
        weights = new double[values.length * Air.CHANNELS];
    }

    /** Returns the Legendre coefficients 2π ∫ p P_l of a phase function, for the degrees up to a largest one. */
    static double[] mieMoments(Air air, int degree) {
        double[] moments = new double[degree + 1];
        GaussLegendre rule = new GaussLegendre(96);
        for (int k = 0; k < rule.nodes.length; k++) {
            // The square brings the nodes close together at the peak.
            double fromPeak = rule.nodes[k] * rule.nodes[k];
            double cosine = 1 - 2 * fromPeak;
            double weight = rule.weights[k] * 4 * rule.nodes[k] * 2 * Math.PI * air.miePhase(cosine);
            double before = 0;
            double now = 1;
            for (int l = 0; l <= degree; l++) {
                moments[l] += weight * now;
                double next = ((2 * l + 1) * cosine * now - l * before) / (l + 1);
                before = now;
                now = next;
            }
        }
        return moments;
    }

    @Override
    public void put(AirRay ray, double[] radiancePerMetre) {
        double mu = ray.pointZenithCosine();
        double sun = ray.pointSunCosine();
        double sines = Math.sqrt((1 - mu * mu) * (1 - sun * sun));
        double azimuth = sines > 1e-9 ? (ray.betweenCosine() - mu * sun) / sines : 1;
        double mie = air.miePerMetre() * ray.pointAerosols();
        boolean hasAerosols = mie > LEAST_AEROSOLS * Air.rayleighPerMetre(0) * ray.pointMolecules();
        int degree = hasAerosols ? field.degree() : MOLECULES_DEGREE;
        int count = DirectionMoments.count(degree);
        harmonics.put(mu, Math.max(-1, Math.min(1, azimuth)), degree, values);
        for (int c = 0; c < Air.CHANNELS; c++) {
            double rayleigh = Air.rayleighPerMetre(c) * ray.pointMolecules();
            int at = c * count;
            for (int l = 0; l <= degree; l++) {
                double fraction = mie * mieMoments[l] + (l == 0 ? rayleigh : l == 2 ? 0.1 * rayleigh : 0);
                for (int m = 0; m <= l; m++) {
                    int k = DirectionMoments.index(l, m);
                    weights[at + k] = fraction * values[k];
                }
            }
        }
        field.putSum(ray.pointHeightMetres(), sun, weights, count, radiancePerMetre);
    }
}
