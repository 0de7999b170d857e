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
 * From where and how the scene is seen. Right, up and back are orthonormal world directions; the view looks along −back.
 * They are right-handed, but left-handed in a {@link #isMirrored mirrored} view, which sees triangles the other way round.
 *
 * <p>Whoever is given one cannot change it; one that was made by constructor or factory never changes and may be kept. The view of a
 * {@link ViewNode} behind an opening, however, is filled anew whenever its {@link ViewTree} grows, so that it allocates
 * nothing: it is good for that frame, and longer only for {@link ViewHistory}, whose tree does not grow meanwhile. For
 * that reason a view equals nothing but itself.
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
     * @param eye world metres
     * @param clip only what is in front of it is seen, as behind an opening; {@code null} for everything
     */
    public View(Vec3 eye, Vec3 right, Vec3 up, Vec3 back, Projection projection, Plane clip) {
        this.projection = projection;
        this.clip = clip;
        put(eye, this.eye);
        put(right, this.right);
        put(up, this.up);
        put(back, this.back);
        mirrored = this.right.cross(this.up, new Vector3d()).dot(this.back) < 0;
    }

    /** Through no opening. */
    public View(Vec3 eye, Vec3 right, Vec3 up, Vec3 back, Projection projection) {
        this(eye, right, up, back, projection, null);
    }

    private static void put(Vec3 from, Vector3d to) {
        to.set(from.x(), from.y(), from.z());
    }

    /** For a node, to {@link #carry} anew for every frame. */
    static View reusable() {
        return new View();
    }

    /** Becomes what {@code before} sees through an opening, cut by the plane that it looks out of. */
    void carry(View before, Opening opening, Projection newProjection) {
        Isometry passage = opening.isometry();
        projection = newProjection;
        clip = opening.exit();
        mirrored = before.mirrored != passage.isReflection();
        Vec3 kept = opening.tint();
        tint.set(before.tint).mul(kept.x(), kept.y(), kept.z());
        passage.point(eye.set(before.eye));
        passage.direction(right.set(before.right));
        passage.direction(up.set(before.up));
        passage.direction(back.set(before.back));
    }

    /** World metres. */
    public Vec3 eye() {
        return Vec3.of(eye);
    }

    public Vec3 right() {
        return Vec3.of(right);
    }

    public Vec3 up() {
        return Vec3.of(up);
    }

    public Vec3 back() {
        return Vec3.of(back);
    }

    public Projection projection() {
        return projection;
    }

    /** Only what is in front of it is seen, as behind an opening; {@code null} for everything. */
    public Plane clip() {
        return clip;
    }

    /** Whether an odd number of mirrors led here: triangles that face the eye go clockwise in the picture. */
    public boolean isMirrored() {
        return mirrored;
    }

    /** What the openings before this view multiply its radiance by, linear RGB. */
    public Vector3dc tint() {
        return tint;
    }

    /** Whether mirrors before this view keep some light back. */
    public boolean isTinted() {
        return tint.x != 1 || tint.y != 1 || tint.z != 1;
    }

    public double eyeX() {
        return eye.x;
    }

    public double eyeY() {
        return eye.y;
    }

    public double eyeZ() {
        return eye.z;
    }

    /** The part of a world direction that points to the right. */
    public double alongRight(double x, double y, double z) {
        return right.dot(x, y, z);
    }

    public double alongUp(double x, double y, double z) {
        return up.dot(x, y, z);
    }

    /** Towards the eye, away from what is looked at. */
    public double alongBack(double x, double y, double z) {
        return back.dot(x, y, z);
    }

    /** The world direction of so much to the right, up and back. @return {@code out} */
    public Vector3d direction(double toTheRight, double upwards, double backwards, Vector3d out) {
        return out.zero().fma(toTheRight, right).fma(upwards, up).fma(backwards, back);
    }

    /**
     * Looks from {@code eye} to {@code target}; where {@code up} is parallel to that, another up is taken, and where
     * both are one point, the view looks along −z.
     */
    public static View lookAt(Vec3 eye, Vec3 target, Vec3 up, Projection projection) {
        Basis basis = Basis.lookAt(eye, target, up, Basis.WORLD);
        return new View(eye, basis.right(), basis.up(), basis.back(), projection);
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
