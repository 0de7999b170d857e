package nephele.editor.pane;

import java.util.Optional;
import nephele.editor.pane.PaneCamera.PanePoint;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/**
 * An orthographic camera along an axis of the world.
 *
 * @param kind not {@link PaneKind#PERSPECTIVE}
 * @param centre the point in the middle of the picture
 */
public record PlanCamera(PaneKind kind, Vec3 centre, double metresPerPixel) implements PaneCamera {
    /** Rays begin this far before the centre, beyond every level. */
    private static final double START_METRES = 2e7;
    /** Factor on the size of the picture of one notch of the wheel. */
    private static final double ZOOM_PER_NOTCH = 1.25;

    private static final double LEAST_METRES_PER_PIXEL = 1e-4;
    private static final double MOST_METRES_PER_PIXEL = 1e4;
    private static final double FARTHEST_METRES = 1e7;
    /** Free space around what is in focus. */
    private static final double FOCUS_FRACTION = 0.8;

    public PlanCamera {
        if (kind == PaneKind.PERSPECTIVE) {
            throw new IllegalArgumentException("a perspective pane has a PerspectiveCamera");
        }
    }

    @Override
    public Ray ray(double x, double y, PaneSize size) {
        Vec3 on = centre.addScaled((x - size.width() / 2.0) * metresPerPixel, right())
                .addScaled((size.height() / 2.0 - y) * metresPerPixel, up());
        return Ray.of(on.addScaled(-START_METRES, forward()), forward());
    }

    @Override
    public Optional<PanePoint> project(Vec3 point, PaneSize size) {
        Vec3 offset = point.minus(centre);
        double x = size.width() / 2.0 + offset.dot(right()) / metresPerPixel;
        double y = size.height() / 2.0 - offset.dot(up()) / metresPerPixel;
        return Optional.of(new PanePoint(x, y, START_METRES + offset.dot(forward())));
    }

    @Override
    public double metresPerPixel(Vec3 at, PaneSize size) {
        return metresPerPixel;
    }

    @Override
    public Vec3 right() {
        return kind == PaneKind.SIDE ? new Vec3(0, 0, -1) : new Vec3(1, 0, 0);
    }

    @Override
    public Vec3 up() {
        return kind == PaneKind.TOP ? new Vec3(0, 0, -1) : new Vec3(0, 1, 0);
    }

    @Override
    public Vec3 forward() {
        return switch (kind) {
            case TOP -> new Vec3(0, -1, 0);
            case FRONT -> new Vec3(0, 0, -1);
            case SIDE -> new Vec3(-1, 0, 0);
            case PERSPECTIVE -> throw new IllegalStateException("no plan");
        };
    }

    /** Moves the picture with the pointer, by pixels to the right and down. */
    public static PlanCamera pan(PlanCamera camera, double acrossPixels, double downPixels) {
        double metres = camera.metresPerPixel();
        return at(
                camera,
                camera.centre()
                        .addScaled(-acrossPixels * metres, camera.right())
                        .addScaled(downPixels * metres, camera.up()));
    }

    /**
     * Zooms; what is under the pointer stays there.
     *
     * @param notches of the wheel; positive enlarges
     */
    public static PlanCamera zoom(PlanCamera camera, double notches, double x, double y, PaneSize size) {
        double wanted = camera.metresPerPixel() * Math.pow(ZOOM_PER_NOTCH, -notches);
        double metres = limited(wanted);
        double change = camera.metresPerPixel() - metres;
        Vec3 centre = camera.centre()
                .addScaled((x - size.width() / 2.0) * change, camera.right())
                .addScaled((size.height() / 2.0 - y) * change, camera.up());
        return at(new PlanCamera(camera.kind(), camera.centre(), metres), centre);
    }

    private static double limited(double metresPerPixel) {
        return Math.max(LEAST_METRES_PER_PIXEL, Math.min(MOST_METRES_PER_PIXEL, metresPerPixel));
    }

    /** Returns a camera with the centre and zoom of another one, of its own kind. */
    public static PlanCamera linked(PlanCamera camera, PlanCamera leader) {
        return new PlanCamera(camera.kind(), leader.centre(), leader.metresPerPixel());
    }

    /** Returns the camera that shows a box as a whole; it stays for an empty one. */
    public static PlanCamera focus(PlanCamera camera, Aabb box, PaneSize size) {
        if (box.isEmpty()) {
            return camera;
        }
        Vec3 extent = new Vec3(box.maxX() - box.minX(), box.maxY() - box.minY(), box.maxZ() - box.minZ());
        double across = Math.abs(extent.dot(camera.right())) / size.width();
        double upwards = Math.abs(extent.dot(camera.up())) / size.height();
        double wanted = Math.max(across, upwards) / FOCUS_FRACTION;
        double metres = wanted > 0 ? limited(wanted) : camera.metresPerPixel();
        return at(new PlanCamera(camera.kind(), camera.centre(), metres), box.centre());
    }

    /** Returns the camera with another point in the middle of the picture. */
    public static PlanCamera at(PlanCamera camera, Vec3 centre) {
        Vec3 near = new Vec3(within(centre.x()), within(centre.y()), within(centre.z()));
        return new PlanCamera(camera.kind(), near, camera.metresPerPixel());
    }

    private static double within(double metres) {
        return Math.max(-FARTHEST_METRES, Math.min(FARTHEST_METRES, metres));
    }
}
