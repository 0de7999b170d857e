package nephele.editor.proving;

import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PaneLayout;
import nephele.editor.pane.PaneLayout.PaneRectangle;
import nephele.editor.pane.PerspectiveCamera;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.reference.Pinhole;

/**
 * The camera of the perspective pane that is in use, or else of the first one.
 *
 * @param pane index of its view
 * @param size of its pane in pixels
 */
public record PaneEye(int pane, PerspectiveCamera camera, PaneSize size) {
    private static final double NEAR_METRES = 0.05;

    static PaneEye of(ProvingSubject subject) {
        PaneLayout panes = subject.panes();
        PaneRectangle first = null;
        for (PaneRectangle place : panes.rectangles(subject.viewport(), PaneLayout.GAP_PIXELS)) {
            boolean isPerspective = panes.views().get(place.index()).kind() == PaneKind.PERSPECTIVE;
            if (isPerspective && (first == null || place.index() == panes.active())) {
                first = place;
            }
        }
        return first == null
                ? new PaneEye(panes.active(), panes.activeView().perspective(), subject.viewport())
                : new PaneEye(first.index(), panes.views().get(first.index()).perspective(), first.size());
    }

    private Basis basis() {
        return new Basis(camera.right(), camera.up(), camera.forward().negated());
    }

    /** Returns the reference tracer's camera of the whole pane. */
    Pinhole pinhole() {
        double half = Math.tan(Math.toRadians(camera.verticalFovDegrees()) / 2);
        return new Pinhole(camera.eye(), basis(), half * size.aspect(), half, NEAR_METRES, Double.POSITIVE_INFINITY);
    }

    /** Returns the reference tracer's camera of one pixel. */
    Pinhole pinhole(Pixel pixel) {
        var ray = camera.ray(pixel.x() + 0.5, pixel.y() + 0.5, size);
        Vec3 sight = new Vec3(ray.directionX(), ray.directionY(), ray.directionZ());
        Basis towards = Basis.lookAt(Vec3.ZERO, sight, camera.up(), basis());
        double half = Math.tan(Math.toRadians(camera.verticalFovDegrees()) / 2) / size.height();
        return new Pinhole(camera.eye(), towards, half, half, NEAR_METRES, Double.POSITIVE_INFINITY);
    }

    /** A pixel of the pane, from the upper left corner. */
    public record Pixel(int x, int y) {}

    /** Returns the pixel that shows a place, or the middle if none does; {@code null} for no place. */
    Pixel pixel(Vec3 place) {
        if (place != null) {
            var at = camera.project(place, size);
            if (at.isPresent() && isInside(at.get().x(), at.get().y())) {
                return new Pixel((int) at.get().x(), (int) at.get().y());
            }
        }
        return new Pixel(size.width() / 2, size.height() / 2);
    }

    private boolean isInside(double x, double y) {
        return x >= 0 && y >= 0 && x < size.width() && y < size.height();
    }
}
