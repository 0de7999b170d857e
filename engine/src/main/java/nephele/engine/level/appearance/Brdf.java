package nephele.engine.level.appearance;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Metallic-roughness reflection, the twin of {@code brdf.glsl}: Lambert under a GGX lobe with height-correlated Smith
 * shadowing (Heitz 2014, section 5.3) and Schlick's Fresnel (1994). Turquin's factor (2019, equation 16) returns the
 * energy that single scattering loses, and the diffuse part receives what the specular part leaves, so that a white
 * material in a white furnace is exactly white.
 *
 * @param underLobe reflectance that the Lambert part would have without the lobe
 * @param diffuse reflectance of the Lambert part
 * @param f0 reflectance at normal incidence
 * @param alpha2 square of α = roughness²
 * @param nDotV cosine between normal and eye, at least {@link #MIN_N_DOT_V}
 * @param specularGain Turquin's factor
 * @param ambientSpecular reflectance for light that is equal from all directions
 */
public record Brdf(
        Vector3dc underLobe,
        Vector3dc diffuse,
        Vector3dc f0,
        double alpha2,
        double nDotV,
        Vector3dc specularGain,
        Vector3dc ambientSpecular)
        implements Reflectance {
    /** Least roughness; with a smaller one the lobe's peak would overflow for light sources without extent. */
    public static final double MIN_ROUGHNESS = 0.05;

    public static final double MIN_N_DOT_V = 1e-3;

    /** Reflectance of a common dielectric at normal incidence (index of refraction 1.5). */
    public static final double INSULATOR_F0 = 0.04;

    public static Brdf of(Vector3dc baseColour, double roughness, double metallic, double nDotV) {
        double r = clamp(roughness, MIN_ROUGHNESS, 1);
        double m = clamp(metallic, 0, 1);
        double mu = clamp(nDotV, MIN_N_DOT_V, 1);
        Vector3d f0 = new Vector3d(INSULATOR_F0).lerp(baseColour, m);
        double inverse = inverseDirectionalAlbedo(r, mu);
        double all = 1 / inverse;
        double grazing = Math.min(grazingAlbedo(r, mu), all);
        Vector3d gain = new Vector3d(f0).mul(inverse - 1).add(1, 1, 1);
        Vector3d ambient = new Vector3d(f0)
                .mul(all - grazing)
                .add(grazing, grazing, grazing)
                .mul(gain);
        Vector3d diffuse =
                new Vector3d(1).sub(ambient).mul(baseColour).mul(1 - m).max(new Vector3d());
        return new Brdf(new Vector3d(baseColour).mul(1 - m), diffuse, f0, r * r * r * r, mu, gain, ambient);
    }

    @Override
    public Vector3d reflected(Vector3dc normal, Vector3dc toEye, Vector3dc toLight) {
        double nDotL = Math.max(normal.dot(toLight), 0);
        Vector3d half = new Vector3d(toLight).add(toEye);
        half.mul(1 / Math.sqrt(Math.max(half.lengthSquared(), 1e-8)));
        double nDotH = clamp(normal.dot(half), 0, 1);
        double vDotH = clamp(toEye.dot(half), 0, 1);
        double lobe = Reflectance.distribution(alpha2, nDotH) * Reflectance.visibility(alpha2, nDotV, nDotL);
        double away = 1 - vDotH;
        double square = away * away;
        Vector3d fresnel = new Vector3d(1).sub(f0).mul(square * square * away).add(f0);
        return fresnel.mul(specularGain)
                .mul(lobe)
                .add(new Vector3d(diffuse).mul(1 / Math.PI))
                .mul(nDotL);
    }

    /**
     * Returns the inverse of the lobe's reflectance for f0 = 1 under equal light from all directions: a quartic fitted
     * to its integral over roughness 0.05–1 and cosine 0.02–1, with an error of at most 0.05.
     */
    static double inverseDirectionalAlbedo(double r, double mu) {
        double c0 = 1.0504262 + mu * (-0.5534067 + mu * (0.2685067 + mu * (0.7763794 - 0.5312025 * mu)));
        double c1 = 0.2777692 + mu * (3.6072694 + mu * (-4.3980971 + 1.2423761 * mu));
        double c2 = -0.9794563 + mu * (-4.7149996 + 1.3819016 * mu);
        double c3 = 1.0294144 + 5.1598502 * mu;
        return Math.max(c0 + r * (c1 + r * (c2 + r * (c3 - 0.4033368 * r))), 1);
    }

    /**
     * Returns the part of that integral that is weighted with Schlick's (1 − v·h)⁵, fitted in the same way, with an
     * error of at most 0.045.
     */
    static double grazingAlbedo(double r, double mu) {
        double s = 1 - mu;
        double s3 = s * s * s;
        double low = 0.3827297 + r * (0.6488859 - 1.1300490 * r);
        double high = 0.7730444 + r * (-3.4834041 + 2.9353760 * r);
        return Math.max(s3 * (low + s3 * high) - 0.0268499 * r, 0);
    }

    private static double clamp(double x, double low, double high) {
        return Math.min(Math.max(x, low), high);
    }
}
