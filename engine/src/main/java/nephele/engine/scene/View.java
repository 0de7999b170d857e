package nephele.engine.scene;

import nephele.engine.level.Camera;
import nephele.engine.math.Vec3;
import org.joml.Matrix4d;
import org.joml.Vector3d;

/**
 * From where and how the scene is seen. Right, up and back are orthonormal world directions (right-handed: the view
 * looks along −back).
 *
 * @param id distinguishes views of one frame; history is kept by it
 * @param eye world metres
 */
public record View(int id, Vec3 eye, Vec3 right, Vec3 up, Vec3 back, Projection projection) {
    /** The player's or the author's own view, as opposed to one through a portal. */
    public static final int MAIN = 0;

    /** Looks from {@code eye} to {@code target}; where {@code up} is parallel to that, another up is taken. */
    public static View lookAt(Vec3 eye, Vec3 target, Vec3 up, Projection projection) {
        Vector3d back = eye.toVector().sub(target.x(), target.y(), target.z()).normalize();
        Vector3d right = up.toVector().cross(back);
        if (right.lengthSquared() < 1e-12) {
            right = (Math.abs(back.x) < 0.9 ? new Vector3d(1, 0, 0) : new Vector3d(0, 0, 1)).cross(back);
        }
        right.normalize();
        Vector3d trueUp = new Vector3d(back).cross(right);
        return new View(MAIN, eye, value(right), value(trueUp), value(back), projection);
    }

    /** What {@code camera} sees at {@code frame} of its path (wrapping around), or from its position without one. */
    public static View ofCamera(Camera camera, int frame, double aspect) {
        double tanHalfHeight = camera.verticalFovDegrees() > 0
                ? Math.tan(Math.toRadians(camera.verticalFovDegrees()) / 2)
                : Math.tan(Math.toRadians(camera.horizontalFovDegrees()) / 2) / aspect;
        Projection projection =
                new Projection(2 * Math.atan(tanHalfHeight), aspect, camera.nearMetres(), camera.farMetres());
        if (camera.path().isEmpty()) {
            return lookAt(camera.position(), camera.target(), camera.up(), projection);
        }
        Camera.Waypoint at =
                camera.path().get(Math.floorMod(frame, camera.path().size()));
        return lookAt(at.position(), at.target(), camera.up(), projection);
    }

    /**
     * The matrix from world directions with the eye as origin to clip space. No position enters it, so it is as exact a
     * million metres out as at the origin.
     *
     * @return {@code destination}
     */
    public Matrix4d clipFromRelative(Matrix4d destination) {
        double sx = 1 / projection.tanHalfWidth();
        double sy = 1 / projection.tanHalfHeight();
        double near = projection.nearMetres();
        double far = projection.farMetres();
        double a = Double.isInfinite(far) ? -1 : (far + near) / (near - far);
        double b = Double.isInfinite(far) ? -2 * near : 2 * far * near / (near - far);
        return destination.set(
                sx * right.x(),
                sy * up.x(),
                a * back.x(),
                -back.x(),
                sx * right.y(),
                sy * up.y(),
                a * back.y(),
                -back.y(),
                sx * right.z(),
                sy * up.z(),
                a * back.z(),
                -back.z(),
                0,
                0,
                b,
                0);
    }

    private static Vec3 value(Vector3d v) {
        return new Vec3(v.x, v.y, v.z);
    }
}
