package nephele.editor.pane;

import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** The movements of a plan's camera, as functions of the camera before. */
public final class PlanNavigation {
    /** Factor on the size of the picture of one notch of the wheel. */
    private static final double ZOOM_PER_NOTCH = 1.25;

    private static final double LEAST_METRES_PER_PIXEL = 1e-4;
    private static final double MOST_METRES_PER_PIXEL = 1e4;
    private static final double FARTHEST_METRES = 1e7;

    /** Free space around what is in focus. */
    private static final double FOCUS_SHARE = 0.8;

    private PlanNavigation() {}

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
        double wanted = Math.max(across, upwards) / FOCUS_SHARE;
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
