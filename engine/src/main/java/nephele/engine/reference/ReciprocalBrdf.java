package nephele.engine.reference;

import nephele.engine.level.appearance.Brdf;
import nephele.engine.level.appearance.Reflectance;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The drawn reflection in a form that is the same with eye and light exchanged, as paths of light demand it: a GGX lobe
 * that scatters once, a lobe of what facets scatter more often, and a Lambert part under both that receives what they
 * leave (Kulla and Conty 2017, "Revisiting Physically Based Shading at Imageworks"). {@link Brdf} returns the same
 * energy by factors that depend on the eye alone.
 *
 * @param f0 reflectance at normal incidence
 * @param roughness perceptual, α is its square
 * @param nDotV cosine between normal and eye
 * @param diffuse albedo of Lambert part and multiple scattering
 * @param ambientSpecular albedo of the lobe that scatters once
 * @param underLobe reflectance that the Lambert part would have without lobes
 */
record ReciprocalBrdf(
        Vector3dc f0,
        double roughness,
        double alpha2,
        double nDotV,
        Vector3dc diffuse,
        Vector3dc ambientSpecular,
        Vector3dc underLobe)
        implements Reflectance {
    /** A lobe that loses less on the mean has no second one: that would be a spike at the horizon. */
    private static final double LEAST_LOST = 1e-4;

    static ReciprocalBrdf of(Brdf drawn) {
        double roughness = Math.sqrt(Math.sqrt(drawn.alpha2()));
        GgxAlbedo albedo = GgxAlbedo.ALL;
        double mu = drawn.nDotV();
        double grazing = albedo.grazing(roughness, mu);
        Vector3d once = new Vector3d(drawn.f0())
                .mul(albedo.all(roughness, mu) - grazing)
                .add(grazing, grazing, grazing);
        Vector3d lobes = albedo(drawn.f0(), roughness, mu);
        Vector3d rest = new Vector3d(lobes).sub(once);
        rest.add(new Vector3d(1).sub(lobes).mul(drawn.underLobe()));
        return new ReciprocalBrdf(drawn.f0(), roughness, drawn.alpha2(), mu, rest, once, drawn.underLobe());
    }

    @Override
    public Vector3d reflected(Vector3dc normal, Vector3dc toEye, Vector3dc toLight) {
        double nDotL = normal.dot(toLight);
        if (nDotL <= 0) {
            return new Vector3d();
        }
        Vector3d half = new Vector3d(toLight).add(toEye);
        half.div(Math.sqrt(Math.max(half.lengthSquared(), 1e-8)));
        double nDotH = Math.min(Math.max(normal.dot(half), 0), 1);
        double away = 1 - Math.min(Math.max(toEye.dot(half), 0), 1);
        double grazing = away * away * away * away * away;
        double lobe =
                Reflectance.distribution(alpha2, nDotH) * Reflectance.visibility(alpha2, nDotV, Math.min(nDotL, 1));
        Vector3d once = new Vector3d(1).sub(f0).mul(grazing).add(f0).mul(lobe);
        return once.add(scatteredOften(nDotL)).add(underLobes(nDotL)).mul(nDotL);
    }

    private Vector3d scatteredOften(double nDotL) {
        GgxAlbedo albedo = GgxAlbedo.ALL;
        double lostOut = 1 - albedo.all(roughness, nDotV);
        double lostIn = 1 - albedo.all(roughness, nDotL);
        double lostOnMean = 1 - albedo.allOnMean(roughness);
        return lostOnMean < LEAST_LOST
                ? new Vector3d()
                : often(f0, roughness).mul(lostOut * lostIn / (Math.PI * lostOnMean));
    }

    private Vector3d underLobes(double nDotL) {
        Vector3d out = new Vector3d(1).sub(albedo(f0, roughness, nDotV));
        Vector3d in = new Vector3d(1).sub(albedo(f0, roughness, nDotL));
        Vector3d onMean = new Vector3d(1).sub(albedoOnMean(f0, roughness));
        return out.mul(in).mul(underLobe).div(onMean.max(new Vector3d(1e-9)).mul(Math.PI));
    }

    /** Returns the albedo of both lobes for light from one cosine. */
    private static Vector3d albedo(Vector3dc f0, double roughness, double cosine) {
        double all = GgxAlbedo.ALL.all(roughness, cosine);
        double grazing = GgxAlbedo.ALL.grazing(roughness, cosine);
        return new Vector3d(f0)
                .mul(all - grazing)
                .add(grazing, grazing, grazing)
                .add(often(f0, roughness).mul(1 - all));
    }

    private static Vector3d albedoOnMean(Vector3dc f0, double roughness) {
        double all = GgxAlbedo.ALL.allOnMean(roughness);
        double grazing = GgxAlbedo.ALL.grazingOnMean(roughness);
        return new Vector3d(f0)
                .mul(all - grazing)
                .add(grazing, grazing, grazing)
                .add(often(f0, roughness).mul(1 - all));
    }

    /** Returns the Fresnel factor of light that facets scatter more than once; black if there is nearly none. */
    private static Vector3d often(Vector3dc f0, double roughness) {
        double all = GgxAlbedo.ALL.allOnMean(roughness);
        if (1 - all < LEAST_LOST) {
            return new Vector3d();
        }
        Vector3d fresnel = new Vector3d(f0).mul(20).add(1, 1, 1).div(21); // Schlick's mean over the hemisphere
        Vector3d kept = new Vector3d(1).sub(new Vector3d(fresnel).mul(1 - all));
        return fresnel.mul(fresnel).mul(all).div(kept);
    }
}
