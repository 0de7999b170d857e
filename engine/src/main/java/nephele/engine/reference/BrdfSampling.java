package nephele.engine.reference;

import java.util.SplittableRandom;
import nephele.engine.level.appearance.Brdf;
import nephele.engine.level.appearance.Reflectance;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Random directions from which a surface reflects light to the eye, dense where it reflects much: cosine over π for the
 * Lambert part (Malley's method), normals visible to the eye for the GGX lobe (Heitz 2018; sampled as a spherical cap,
 * Dupuy and Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps").
 */
final class BrdfSampling implements PathVertex.DirectionSampling {
    private final SurfacePoint surface;
    private final Vector3d across;
    private final Vector3d up;
    private final double specularProbability;

    BrdfSampling(SurfacePoint surface) {
        this.surface = surface;
        across = Directions.perpendicular(Vec3.of(surface.normal())).toVector();
        up = new Vector3d(surface.normal()).cross(across);
        specularProbability = specularProbability(surface);
    }

    /** An eye below the plane of the shading normal sees no microfacet that the lobe's formula describes. */
    private static double specularProbability(SurfacePoint surface) {
        Reflectance gloss = surface.gloss();
        if (gloss == null || surface.normal().dot(surface.toEye()) < Brdf.MIN_N_DOT_V) {
            return 0;
        }
        double specular = sum(gloss.ambientSpecular());
        return specular / (specular + sum(gloss.diffuse()));
    }

    private static double sum(Vector3dc v) {
        return v.x() + v.y() + v.z();
    }

    @Override
    public Vector3d direction(SplittableRandom random) {
        boolean isSpecular = random.nextDouble() < specularProbability;
        double square = random.nextDouble();
        double angle = 2 * Math.PI * random.nextDouble();
        return isSpecular ? mirrored(square, angle) : aroundNormal(square, angle);
    }

    private Vector3d aroundNormal(double square, double angle) {
        double radius = Math.sqrt(square);
        return world(radius * StrictMath.cos(angle), radius * StrictMath.sin(angle), Math.sqrt(1 - square));
    }

    private Vector3d mirrored(double square, double angle) {
        Vector3dc eye = surface.toEye();
        double alpha = Math.sqrt(surface.gloss().alpha2());
        Vector3d stretched = new Vector3d(
                        alpha * eye.dot(across),
                        alpha * eye.dot(up),
                        surface.normal().dot(eye))
                .normalize();
        double z = (1 - square) * (1 + stretched.z) - stretched.z;
        double radius = Math.sqrt(Math.max(0, 1 - z * z));
        Vector3d half = stretched.add(radius * StrictMath.cos(angle), radius * StrictMath.sin(angle), z);
        Vector3d facet = world(alpha * half.x, alpha * half.y, half.z).normalize();
        return facet.mul(2 * facet.dot(eye)).sub(eye);
    }

    private Vector3d world(double x, double y, double z) {
        return new Vector3d(surface.normal()).mul(z).fma(x, across).fma(y, up);
    }

    @Override
    public double density(Vector3dc towards) {
        double cosine = Math.max(0, surface.normal().dot(towards));
        double diffuse = (1 - specularProbability) * cosine / Math.PI;
        return specularProbability == 0 ? diffuse : diffuse + specularProbability * lobeDensity(towards);
    }

    private double lobeDensity(Vector3dc towards) {
        Reflectance gloss = surface.gloss();
        Vector3d half = new Vector3d(towards).add(surface.toEye());
        double length = half.length();
        if (length == 0) {
            return 0;
        }
        double normalCosine = surface.normal().dot(half) / length;
        double eyeCosine = surface.normal().dot(surface.toEye());
        double smith = eyeCosine + Math.sqrt(gloss.alpha2() + (1 - gloss.alpha2()) * eyeCosine * eyeCosine);
        return normalCosine <= 0 ? 0 : Reflectance.distribution(gloss.alpha2(), normalCosine) / (2 * smith);
    }
}
