package nephele.engine.reference;

import nephele.engine.level.appearance.Brdf;
import nephele.engine.level.appearance.Terminator;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Where a ray of the eye ends, and what is there.
 *
 * @param item as {@link SurfaceRays} numbers it
 * @param normal unit, bent by a normal map
 * @param smoothNormal unit, of the surface that the geometry stands for: its own unless that is a mesh
 * @param faceNormal unit, of the geometry
 * @param albedo what a Lambert surface reflects; unused with {@code gloss}
 * @param gloss {@code null} for a Lambert surface
 * @param toEye unit
 * @param emission radiance of its own
 */
record SurfacePoint(
        int item,
        Vec3 place,
        Vector3dc normal,
        Vector3dc smoothNormal,
        Vector3dc faceNormal,
        Vector3dc albedo,
        Brdf gloss,
        Vector3dc toEye,
        Vec3 emission) {

    /** Radiance towards the eye per irradiance on a plane across the beam. */
    Vector3d reflected(Vector3dc toLight) {
        Vector3d reflected = gloss == null
                ? new Vector3d(albedo).mul(Math.max(normal.dot(toLight), 0) / Math.PI)
                : gloss.reflected(normal, toEye, toLight);
        return smoothNormal == faceNormal
                ? reflected
                : reflected.mul(Terminator.share(smoothNormal, faceNormal, toLight));
    }

    /** Radiance towards the eye under light from all around: what falls on the normal, and what is mirrored. */
    Vector3d reflected(Vector3dc onNormal, Vector3dc mirrored) {
        if (gloss == null) {
            return new Vector3d(albedo).mul(onNormal);
        }
        return new Vector3d(gloss.diffuse()).mul(onNormal).add(new Vector3d(gloss.ambientSpecular()).mul(mirrored));
    }

    /** Where a smooth surface would mirror the eye's ray to. */
    Vector3d mirrorDirection() {
        return new Vector3d(normal).mul(2 * normal.dot(toEye)).sub(toEye);
    }
}
