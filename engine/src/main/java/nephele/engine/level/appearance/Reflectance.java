package nephele.engine.level.appearance;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** What a surface with a GGX lobe reflects towards one eye. */
public interface Reflectance {
    /** Returns the square of α = roughness². */
    double alpha2();

    /** Returns the albedo of everything but the lobe that scatters once. */
    Vector3dc diffuse();

    /** Returns the reflectance of the lobe for light that is equal from all directions. */
    Vector3dc ambientSpecular();

    /**
     * Returns the reflected radiance per irradiance on a plane perpendicular to {@code toLight}; all vectors have unit
     * length.
     */
    Vector3d reflected(Vector3dc normal, Vector3dc toEye, Vector3dc toLight);

    /** Returns the GGX distribution (Walter et al. 2007, equation 33). */
    static double distribution(double alpha2, double nDotH) {
        double d = Math.max(1 - nDotH * nDotH * (1 - alpha2), 1e-6);
        return alpha2 / (Math.PI * d * d);
    }

    /** Returns Smith's G divided by 4 · n·l · n·v (Heitz 2014, section 5.3). */
    static double visibility(double alpha2, double nDotV, double nDotL) {
        double towardsEye = nDotL * Math.sqrt(nDotV * nDotV * (1 - alpha2) + alpha2);
        double towardsLight = nDotV * Math.sqrt(nDotL * nDotL * (1 - alpha2) + alpha2);
        return 0.5 / Math.max(towardsEye + towardsLight, 1e-6);
    }
}
