package nephele.editor.pane;

import java.util.Optional;
import nephele.editor.pane.PaneCamera.PanePoint;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.engine.math.Aabb;
import nephele.engine.math.Basis;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/**
 * A perspective camera. Yaw 0 looks along −z, positive to the left; pitch is positive upwards.
 *
 * @param verticalFovDegrees full angle between the lower and the upper border
 */
public record PerspectiveCamera(Vec3 eye, double yawDegrees, double pitchDegrees, double verticalFovDegrees)
        implements PaneCamera {
    private static final double STEEPEST_DEGREES = 89.9;
    /** Fraction of the distance to what is under the pointer that one notch of the wheel covers. */
    private static final double DOLLY_FRACTION = 0.15;

    private static final double FARTHEST_METRES = 1e7;
    private static final double LEAST_FOCUS_METRES = 0.5;
    /** Free space around what is in focus. */
    private static final double FOCUS_MARGIN = 1.15;

    public PerspectiveCamera {
        pitchDegrees = Math.max(-STEEPEST_DEGREES, Math.min(STEEPEST_DEGREES, pitchDegrees));
    }

    private Basis basis() {
        return Basis.ofYawPitch(Math.toRadians(yawDegrees), Math.toRadians(pitchDegrees));
    }

    @Override
    public Ray ray(double x, double y, PaneSize size) {
        double half = Math.tan(Math.toRadians(verticalFovDegrees) / 2);
        double across = (2 * x / size.width() - 1) * half * size.aspect();
        double upward = (1 - 2 * y / size.height()) * half;
        Basis basis = basis();
        Vec3 direction = basis.back().negated().addScaled(across, basis.right()).addScaled(upward, basis.up());
        return Ray.of(eye, direction.scaled(1 / direction.length()));
    }

    @Override
    public Optional<PanePoint> project(Vec3 point, PaneSize size) {
        Basis basis = basis();
        Vec3 offset = point.minus(eye);
        double depth = -offset.dot(basis.back());
        if (!(depth > 1e-6)) {
            return Optional.empty();
        }
        double half = depth * Math.tan(Math.toRadians(verticalFovDegrees) / 2);
        double x = (1 + offset.dot(basis.right()) / (half * size.aspect())) * size.width() / 2;
        double y = (1 - offset.dot(basis.up()) / half) * size.height() / 2;
        return Optional.of(new PanePoint(x, y, depth));
    }

    @Override
    public double metresPerPixel(Vec3 at, PaneSize size) {
        double depth = Math.max(1e-3, at.minus(eye).dot(forward()));
        return 2 * depth * Math.tan(Math.toRadians(verticalFovDegrees) / 2) / size.height();
    }

    @Override
    public Vec3 right() {
        return basis().right();
    }

    @Override
    public Vec3 up() {
        return basis().up();
    }

    @Override
    public Vec3 forward() {
        return basis().back().negated();
    }

    /** Turns the camera in place; pixels to the right and down turn it right and down. */
    public static PerspectiveCamera look(
            PerspectiveCamera camera, double acrossPixels, double downPixels, double degreesPerPixel) {
        return turned(
                camera,
                camera.yawDegrees() - acrossPixels * degreesPerPixel,
                camera.pitchDegrees() - downPixels * degreesPerPixel);
    }

    private static PerspectiveCamera turned(PerspectiveCamera camera, double yawDegrees, double pitchDegrees) {
        double yaw = Math.IEEEremainder(yawDegrees, 360);
        return new PerspectiveCamera(camera.eye(), yaw, pitchDegrees, camera.verticalFovDegrees());
    }

    /**
     * Flies.
     *
     * @param keys held to the right, up and forward, from −1 to 1 each; up is the world's, the others are the camera's
     * @param metres that full speed covers
     */
    public static PerspectiveCamera fly(PerspectiveCamera camera, Vec3 keys, double metres) {
        Vec3 wanted = camera.right()
                .scaled(keys.x())
                .addScaled(keys.y(), new Vec3(0, 1, 0))
                .addScaled(keys.z(), camera.forward());
        double length = wanted.length();
        double shortened = length > 1 ? 1 / length : 1;
        return at(camera, camera.eye().addScaled(shortened * metres, wanted));
    }

    /**
     * Moves along the ray of sight through the pointer, whose point stays under it.
     *
     * @param notches of the wheel; positive approaches
     * @param distanceMetres to what is under the pointer
     */
    public static PerspectiveCamera dolly(PerspectiveCamera camera, double notches, Ray sight, double distanceMetres) {
        double fraction = 1 - Math.pow(1 - DOLLY_FRACTION, notches);
        return at(camera, sight.at(distanceMetres * fraction));
    }

    /** Turns the camera around a point, which stays at its place in the picture. */
    public static PerspectiveCamera orbit(
            PerspectiveCamera camera, Vec3 about, double acrossDegrees, double downDegrees) {
        Vec3 fromEye = about.minus(camera.eye());
        PerspectiveCamera after =
                turned(camera, camera.yawDegrees() - acrossDegrees, camera.pitchDegrees() - downDegrees);
        Vec3 eye = about.addScaled(-fromEye.dot(camera.right()), after.right())
                .addScaled(-fromEye.dot(camera.up()), after.up())
                .addScaled(-fromEye.dot(camera.forward()), after.forward());
        return at(after, eye);
    }

    /** Moves the picture with the pointer, by pixels to the right and down, at the distance of a point. */
    public static PerspectiveCamera pan(
            PerspectiveCamera camera, double acrossPixels, double downPixels, Vec3 grabbed, PaneSize size) {
        double metres = camera.metresPerPixel(grabbed, size);
        return at(
                camera,
                camera.eye()
                        .addScaled(-acrossPixels * metres, camera.right())
                        .addScaled(downPixels * metres, camera.up()));
    }

    /** Returns the camera that sees a box as a whole in the same direction; it stays for an empty one. */
    public static PerspectiveCamera focus(PerspectiveCamera camera, Aabb box, PaneSize size) {
        if (box.isEmpty()) {
            return camera;
        }
        Vec3 half = new Vec3(box.maxX() - box.minX(), box.maxY() - box.minY(), box.maxZ() - box.minZ()).scaled(0.5);
        double radius = Math.max(LEAST_FOCUS_METRES, half.length());
        double halfAngle = Math.toRadians(camera.verticalFovDegrees()) / 2;
        double narrower = Math.min(halfAngle, Math.atan(Math.tan(halfAngle) * size.aspect()));
        double distance = FOCUS_MARGIN * radius / Math.sin(narrower);
        return at(camera, box.centre().addScaled(-distance, camera.forward()));
    }

    /** Returns the camera at another place. */
    public static PerspectiveCamera at(PerspectiveCamera camera, Vec3 eye) {
        Vec3 near = new Vec3(within(eye.x()), within(eye.y()), within(eye.z()));
        return new PerspectiveCamera(near, camera.yawDegrees(), camera.pitchDegrees(), camera.verticalFovDegrees());
    }

    private static double within(double metres) {
        return Math.max(-FARTHEST_METRES, Math.min(FARTHEST_METRES, metres));
    }
}
