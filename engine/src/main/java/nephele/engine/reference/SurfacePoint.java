package nephele.engine.reference;

import nephele.engine.level.appearance.Brdf;
import nephele.engine.level.appearance.Reflectance;
import nephele.engine.level.billboard.PlantedBillboards;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The end point of an eye ray with its surface properties.
 *
 * @param item number as in {@link TracedItems}
 * @param normal unit, perturbed by a normal map
 * @param smoothNormal unit, of the surface that the geometry approximates: equal to {@code faceNormal} unless that is a
 *     mesh
 * @param faceNormal unit, of the geometry
 * @param albedo reflectance of a Lambert surface; unused with {@code gloss}
 * @param gloss {@code null} for a Lambert surface
 * @param toEye unit
 * @param emission emitted radiance
 * @param leaves whether it is a billboard's leaves, on which the sun shines from all sides
 */
record SurfacePoint(
        int item,
        Vec3 place,
        Vector3dc normal,
        Vector3dc smoothNormal,
        Vector3dc faceNormal,
        Vector3dc albedo,
        Reflectance gloss,
        Vector3dc toEye,
        Vec3 emission,
        boolean leaves)
        implements PathVertex {
    @Override
    public Vector3d rayOrigin() {
        return Illumination.lifted(this);
    }

    @Override
    public boolean isReachedFrom(Vector3dc towardsLight) {
        return faceNormal.dot(towardsLight) > 0;
    }

    @Override
    public BrdfSampling sampling() {
        return new BrdfSampling(this);
    }

    /** Returns this point as light's transport demands it: it reflects as much backwards along any path as forwards. */
    SurfacePoint reciprocal() {
        return gloss instanceof Brdf drawn
                ? new SurfacePoint(
                        item,
                        place,
                        normal,
                        smoothNormal,
                        faceNormal,
                        albedo,
                        ReciprocalBrdf.of(drawn),
                        toEye,
                        emission,
                        leaves)
                : this;
    }

    /** Returns true if the surface faces the sun, or lets its light through. */
    boolean isTowards(Vector3dc sun) {
        return leaves || faceNormal.dot(sun) > 0;
    }

    /** Returns the radiance towards the eye per irradiance of the sun on a plane perpendicular to its light. */
    Vector3d sunlit(Vector3dc sun) {
        if (!leaves) {
            return reflected(sun);
        }
        double cosine = new Vector3d(normal)
                .fma(PlantedBillboards.THROUGH, sun)
                .normalize()
                .dot(sun);
        return new Vector3d(albedo).mul(PlantedBillboards.BETWEEN_LEAVES * Math.max(cosine, 0) / Math.PI);
    }

    @Override
    public Vector3d reflected(Vector3dc toLight) {
        Vector3d reflected = gloss == null
                ? new Vector3d(albedo).mul(Math.max(normal.dot(toLight), 0) / Math.PI)
                : gloss.reflected(normal, toEye, toLight);
        return smoothNormal == faceNormal ? reflected : reflected.mul(terminator(smoothNormal, faceNormal, toLight));
    }

    /** Returns the radiance towards the eye under ambient light, irradiance / π at the normal and mirror direction. */
    Vector3d reflected(Vector3dc onNormal, Vector3dc mirrored) {
        if (gloss == null) {
            return new Vector3d(albedo).mul(onNormal);
        }
        return new Vector3d(gloss.diffuse()).mul(onNormal).add(new Vector3d(gloss.ambientSpecular()).mul(mirrored));
    }

    /** Returns the direction into which a mirror with this normal would reflect the eye ray. */
    Vector3d mirrorDirection() {
        return new Vector3d(normal).mul(2 * normal.dot(toEye)).sub(toEye);
    }

    /**
     * Returns the fraction of light that arrives at a triangle that faces the light; 1 if the triangle is as flat as the
     * curved surface that it approximates. A flat triangle faces away at once where the surface would do so gradually, so
     * light would end along the triangles' edges; instead it fades (Chiang, Li and Burley 2019, "Taming the Shadow
     * Terminator").
     *
     * @param smoothNormal unit normal of the curved surface
     * @param faceNormal unit normal of the triangle
     * @param toLight unit
     */
    private static double terminator(Vector3dc smoothNormal, Vector3dc faceNormal, Vector3dc toLight) {
        double onCurve = smoothNormal.dot(toLight) * faceNormal.dot(smoothNormal);
        double g = onCurve > 0 ? Math.min(faceNormal.dot(toLight) / onCurve, 1) : 1;
        return g * (1 + g - g * g);
    }
}
