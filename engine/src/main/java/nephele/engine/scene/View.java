package nephele.engine.scene;

import nephele.engine.level.Camera;
import nephele.engine.math.Basis;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import org.joml.Matrix4d;

/**
 * From where and how the scene is seen. Right, up and back are orthonormal world directions (right-handed: the view
 * looks along −back).
 *
 * @param id distinguishes views of one frame; history is kept by it
 * @param eye world metres
 * @param clip only what is in front of it is seen, as behind a portal; {@code null} for everything
 */
public record View(int id, Vec3 eye, Vec3 right, Vec3 up, Vec3 back, Projection projection, Plane clip) {
    /** The player's or the author's own view, as opposed to one through a portal. */
    public static final int MAIN = 0;

    /** Through no portal. */
    public View(int id, Vec3 eye, Vec3 right, Vec3 up, Vec3 back, Projection projection) {
        this(id, eye, right, up, back, projection, null);
    }

    /**
     * Looks from {@code eye} to {@code target}; where {@code up} is parallel to that, another up is taken, and where
     * both are one point, the view looks along −z.
     */
    public static View lookAt(Vec3 eye, Vec3 target, Vec3 up, Projection projection) {
        Basis basis = Basis.lookAt(eye, target, up, Basis.WORLD);
        return new View(MAIN, eye, basis.right(), basis.up(), basis.back(), projection);
    }

    /** What {@code camera} sees at {@code frame} of its path (wrapping around), or from its position without one. */
    public static View ofCamera(Camera camera, int frame, double aspect) {
        double near = camera.nearMetres();
        double far = camera.farMetres();
        Projection projection = camera.verticalFovDegrees() > 0
                ? new Projection(Math.toRadians(camera.verticalFovDegrees()), aspect, near, far)
                : Projection.ofHorizontalFov(Math.toRadians(camera.horizontalFovDegrees()), aspect, near, far);
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
        double a = projection.depthScale();
        double b = projection.depthOffset();
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
}
