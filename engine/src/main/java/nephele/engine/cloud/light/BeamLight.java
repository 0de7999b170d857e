package nephele.engine.cloud.light;

/**
 * Sunlight that goes along the beam up to a point of a cloud and is scattered towards the eye there. Light that leaves the
 * beam is lost, so thick clouds are too dark; nothing is brighter than under the whole beam.
 *
 * @param optics of the cloud
 * @param fading of the beam per optical depth, 0 to 1
 */
public record BeamLight(CloudOptics optics, double fading) {
    /** Solid angle γ in which forward scattering counts as part of the beam (Harris and Lastra 2001; 0.09 in their program). */
    static final double CONE_STERADIANS = Math.PI / 32;

    /** Returns light that is scattered once only: the beam loses all that is scattered. */
    public static BeamLight once(CloudOptics optics) {
        return new BeamLight(optics, 1);
    }

    /**
     * Returns light that is scattered forwards any number of times (Harris and Lastra 2001, "Real-Time Cloud Rendering"). Their
     * particle k of optical depth τ<sub>k</sub> passes on I<sub>k+1</sub> = (e<sup>−τ<sub>k</sub></sup> + ω τ<sub>k</sub> p(0) γ)
     * I<sub>k</sub>, p per steradian. That depends on how many particles share a depth, and grows without bound where ω p(0) γ
     * exceeds 1. For particles without end of no depth it becomes dI/dτ = −(1 − f) I with f = ω p(0) γ, so I = e<sup>−(1 − f) τ</sup>.
     * Here f is ω times the fraction of light that is scattered into a cone of γ: the same where p hardly changes in the cone,
     * and at most 1 where it has a peak.
     */
    public static BeamLight forwards(CloudOptics optics) {
        // The cap of a sphere between separations 0 and s has the solid angle π s.
        double fraction = optics.fractionWithin(CONE_STERADIANS / Math.PI);
        return new BeamLight(optics, 1 - optics.albedo() * fraction);
    }

    /** Returns the irradiance of the beam at a point per unit irradiance of the sun. */
    public double irradiance(double sunDepth) {
        return Math.exp(-fading * sunDepth);
    }

    /** Returns the light that one optical depth scatters towards the eye, per unit irradiance of the sun and steradian. */
    public double perDepth(double separation, double sunDepth) {
        return optics.albedo() * optics.perSteradian(separation) * irradiance(sunDepth);
    }
}
