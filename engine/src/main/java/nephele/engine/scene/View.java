package nephele.engine.scene;

import nephele.engine.level.Camera;
import nephele.engine.math.Basis;
import nephele.engine.math.Isometry;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * A camera: its position, orientation and projection, and the plane that clips it. Right, up and back are orthonormal
 * world directions; the view looks along −back. They are right-handed, but left-handed in a
 * {@link #isMirrored mirrored} view, which reverses the winding of triangles.
 *
 * <p>A view has no public mutators; one made by constructor or factory never changes and may be kept. The view of a
 * {@link ViewNode} behind an opening, however, is refilled whenever its {@link ViewTree} grows, to allocate nothing: it
 * is valid for that frame, and longer only for {@link ViewHistory}, as its tree does not grow meanwhile. Therefore
 * views are compared by identity.
 */
public final class View {
    private final Vector3d eye = new Vector3d();
    private final Vector3d right = new Vector3d();
    private final Vector3d up = new Vector3d();
    private final Vector3d back = new Vector3d();
    private final Vector3d tint = new Vector3d(1);
    private Projection projection;
    private Plane clip;
    private boolean mirrored;

    private View() {}

    /**
     * Makes a view from orthonormal axes.
     *
     * @param eye world metres
     * @param clip only what is in front of it is visible, as behind an opening; {@code null} for no clipping
     */
    public View(Vec3 eye, Vec3 right, Vec3 up, Vec3 back, Projection projection, Plane clip) {
        this.projection = projection;
        this.clip = clip;
        put(eye, this.eye);
        put(right, this.right);
        put(up, this.up);
        put(back, this.back);
        mirrored = right.cross(up).dot(back) < 0;
    }

    /** Makes a view that no plane clips. */
    public View(Vec3 eye, Vec3 right, Vec3 up, Vec3 back, Projection projection) {
        this(eye, right, up, back, projection, null);
    }

    private static void put(Vec3 from, Vector3d to) {
        to.set(from.x(), from.y(), from.z());
    }

    /** Makes the view of a node, to be refilled by {@link #setThrough} in every frame. */
    static View reusable() {
        return new View();
    }

    /** Becomes the image of {@code before} under an opening's map, clipped at the opening's exit plane. */
    void setThrough(View before, Opening opening, Projection newProjection) {
        Isometry transform = opening.isometry();
        projection = newProjection;
        clip = opening.exit();
        mirrored = before.mirrored != transform.isReflection();
        Vec3 kept = opening.tint();
        tint.set(before.tint).mul(kept.x(), kept.y(), kept.z());
        transform.point(eye.set(before.eye));
        transform.direction(right.set(before.right));
        transform.direction(up.set(before.up));
        transform.direction(back.set(before.back));
    }

    /** Returns the position in world metres. */
    public Vec3 eye() {
        return Vec3.of(eye);
    }

    /** Returns the world direction to the right, unit length. */
    public Vec3 right() {
        return Vec3.of(right);
    }

    /** Returns the world direction upwards in the picture, unit length. */
    public Vec3 up() {
        return Vec3.of(up);
    }

    /** Returns the world direction opposite to the view direction, unit length. */
    public Vec3 back() {
        return Vec3.of(back);
    }

    /** Returns the projection. */
    public Projection projection() {
        return projection;
    }

    /** Returns the clip plane, as behind an opening: only its front is visible; {@code null} for no clipping. */
    public Plane clip() {
        return clip;
    }

    /** Returns true after an odd number of mirrors: triangles that face the eye are clockwise in the picture. */
    public boolean isMirrored() {
        return mirrored;
    }

    /** Returns the product of the tints of the openings before this view, linear RGB. */
    public Vector3dc tint() {
        return tint;
    }

    /** Returns true if a mirror before this view absorbs light. */
    public boolean isTinted() {
        return tint.x != 1 || tint.y != 1 || tint.z != 1;
    }

    /** Returns the x coordinate of the position in world metres. */
    public double eyeX() {
        return eye.x;
    }

    /** Returns the y coordinate of the position in world metres. */
    public double eyeY() {
        return eye.y;
    }

    /** Returns the z coordinate of the position in world metres. */
    public double eyeZ() {
        return eye.z;
    }

    /** Returns the component of a world direction along right. */
    public double alongRight(double x, double y, double z) {
        return right.dot(x, y, z);
    }

    /** Returns the component of a world direction along up. */
    public double alongUp(double x, double y, double z) {
        return up.dot(x, y, z);
    }

    /** Returns the component of a world direction along back, away from the target. */
    public double alongBack(double x, double y, double z) {
        return back.dot(x, y, z);
    }

    /** Returns true for a view from the same place in the same directions, with the same projection. */
    public boolean isSameAs(View other) {
        return eye.equals(other.eye)
                && right.equals(other.right)
                && up.equals(other.up)
                && back.equals(other.back)
                && projection.equals(other.projection);
    }

    /**
     * Converts view coordinates to a world direction.
     *
     * @return {@code out}
     */
    public Vector3d direction(double toTheRight, double upwards, double backwards, Vector3d out) {
        return out.zero().fma(toTheRight, right).fma(upwards, up).fma(backwards, back);
    }

    /**
     * Returns the view from {@code eye} to {@code target}. If {@code up} is parallel to that direction, another up is
     * chosen; if both points are equal, the view looks along −z.
     */
    public static View lookAt(Vec3 eye, Vec3 target, Vec3 up, Projection projection) {
        Basis basis = Basis.lookAt(eye, target, up, Basis.WORLD);
        return new View(eye, basis.right(), basis.up(), basis.back(), projection);
    }

    /** Returns the view of {@code camera} at {@code frame} of its path (which wraps around), or at its position. */
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
     * Returns the matrix from world directions relative to the eye to clip space. It contains no position, so it is as
     * exact a million metres out as at the origin.
     *
     * @return {@code destination}
     */
    public Matrix4d clipFromRelative(Matrix4d destination) {
        double sx = 1 / projection.tanHalfWidth();
        double sy = 1 / projection.tanHalfHeight();
        double a = projection.depthScale();
        double b = projection.depthOffset();
        return destination.set(
                sx * right.x,
                sy * up.x,
                a * back.x,
                -back.x,
                sx * right.y,
                sy * up.y,
                a * back.y,
                -back.y,
                sx * right.z,
                sy * up.z,
                a * back.z,
                -back.z,
                0,
                0,
                b,
                0);
    }

    @Override
    public String toString() {
        return "View from " + eye() + " looking along " + Vec3.of(back.negate(new Vector3d()));
    }
}
