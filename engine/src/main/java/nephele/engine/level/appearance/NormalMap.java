package nephele.engine.level.appearance;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Tangent-space normals; the twin of {@code normal-map.glsl}. */
public final class NormalMap {
    /** Least outward component of a mapped normal; a smaller one could bend the normal below the face. */
    public static final double MIN_OUTWARD = 0.1;

    private NormalMap() {}

    /**
     * Returns the mapped normal.
     *
     * @param texel red, green, blue of the map, 0–1
     * @param across direction in which the texture's u grows on the face, {@code up} that of its v
     */
    public static Vector3d mapped(Vector3dc texel, Vector3dc faceNormal, Vector3dc across, Vector3dc up) {
        Vector3d n = new Vector3d(faceNormal).mul(Math.max(texel.z() * 2 - 1, MIN_OUTWARD));
        n.fma(texel.x() * 2 - 1, across).fma(texel.y() * 2 - 1, up);
        return n.mul(1 / Math.sqrt(Math.max(n.lengthSquared(), 1e-8)));
    }
}
