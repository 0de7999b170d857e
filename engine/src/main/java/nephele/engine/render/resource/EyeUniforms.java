package nephele.engine.render.resource;

import nephele.engine.math.Vec3;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.scene.View;

/**
 * The uniforms of an eye relative to a place near the vertices: each coordinate is the sum of two floats, exact to 1e-12 of
 * the distance.
 */
public record EyeUniforms(Vector3 eyeHigh, Vector3 eyeLow) {
    /** Sets the eye of a view. */
    public void set(View view, Vec3 place) {
        set(view.eyeX() - place.x(), view.eyeY() - place.y(), view.eyeZ() - place.z());
    }

    void set(double x, double y, double z) {
        eyeHigh.set(x, y, z);
        eyeLow.set(x - (float) x, y - (float) y, z - (float) z);
    }
}
