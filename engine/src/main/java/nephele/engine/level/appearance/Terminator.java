package nephele.engine.level.appearance;

import org.joml.Vector3dc;

/**
 * Light near its end on a curve that triangles stand for. A triangle turns away at once, the curve does not yet, so light
 * would end along the triangles' edges: it fades instead (Chiang, Li and Burley 2019, "Taming the Shadow Terminator").
 */
public final class Terminator {
    private Terminator() {}

    /**
     * The share of light that arrives at a triangle that faces it; 1 where the triangle is as flat as its surface.
     *
     * @param smoothNormal unit, of the curve
     * @param faceNormal unit, of the triangle
     * @param toLight unit
     */
    public static double share(Vector3dc smoothNormal, Vector3dc faceNormal, Vector3dc toLight) {
        double onCurve = smoothNormal.dot(toLight) * faceNormal.dot(smoothNormal);
        double g = onCurve > 0 ? Math.min(faceNormal.dot(toLight) / onCurve, 1) : 1;
        return g * (1 + g - g * g);
    }
}
