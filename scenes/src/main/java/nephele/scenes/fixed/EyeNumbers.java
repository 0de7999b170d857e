package nephele.scenes.fixed;

import nephele.engine.scene.View;
import org.joml.Matrix4d;
import org.joml.Vector3d;

/** The numbers of a view in the form of shader uniforms; one object serves all frames. */
final class EyeNumbers {
    private final Matrix4d clipFromRelative = new Matrix4d();
    private final float[] columns = new float[16];
    private final Vector3d back = new Vector3d();
    private float x;
    private float y;
    private float z;

    void set(View view) {
        view.clipFromRelative(clipFromRelative).get(columns);
        view.direction(0, 0, 1, back);
        x = (float) view.eyeX();
        y = (float) view.eyeY();
        z = (float) view.eyeZ();
    }

    float x() {
        return x;
    }

    float y() {
        return y;
    }

    float z() {
        return z;
    }

    /** Returns true if the eye is so close to an axis that this axis is seen as a point or not at all. */
    boolean isOnAxis() {
        double near = 1e-3 * Math.max(1, Math.sqrt((double) x * x + (double) y * y + (double) z * z));
        return Math.hypot(y, z) < near || Math.hypot(x, z) < near || Math.hypot(x, y) < near;
    }

    float backX() {
        return (float) back.x;
    }

    float backY() {
        return (float) back.y;
    }

    float backZ() {
        return (float) back.z;
    }

    float[] clipFromRelative() {
        return columns;
    }

    /** Returns the matrix for culling; callers must not change it. */
    Matrix4d exactClipFromRelative() {
        return clipFromRelative;
    }
}
