package nephele.engine.scene.light;

import org.joml.Vector3d;

/**
 * The cosine-weighted share of the hemisphere about a surface's normal that a sphere hides; in twice the precision of its
 * twin, the shader {@code include/contact.glsl}.
 */
final class ContactShare {
    private ContactShare() {}

    /**
     * Returns the share.
     *
     * @param centre relative to the surface, in the radius' unit
     * @param normal unit
     */
    static double ofSphere(Vector3d centre, double radius, Vector3d normal) {
        double distance = Math.max(centre.length(), radius);
        double height = centre.dot(normal);
        double above = Math.max(height + radius, 0);
        double seen = height > radius ? height : above * above / (4 * radius);
        return seen * radius * radius / (distance * distance * distance);
    }
}
