package nephele.engine.level.appearance;

import org.joml.Vector3dc;

/**
 * Light near the terminator of a curved surface that triangles approximate. A flat triangle faces away at once where
 * the surface would do so gradually, so light would end along the triangles' edges; instead it fades (Chiang, Li and
 * Burley 2019, "Taming the Shadow Terminator").
 */
public final class Terminator {
    private Terminator() {}

    /**
     * Returns the share of light that arrives at a triangle that faces the light; 1 if the triangle is as flat as its
     * surface.
     *
     * @param smoothNormal unit normal of the curved surface
     * @param faceNormal unit normal of the triangle
     * @param toLight unit
     */
    public static double share(Vector3dc smoothNormal, Vector3dc faceNormal, Vector3dc toLight) {
        double onCurve = smoothNormal.dot(toLight) * faceNormal.dot(smoothNormal);
        double g = onCurve > 0 ? Math.min(faceNormal.dot(toLight) / onCurve, 1) : 1;
        return g * (1 + g - g * g);
    }
}
