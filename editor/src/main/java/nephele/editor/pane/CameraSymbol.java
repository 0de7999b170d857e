package nephele.editor.pane;

import java.util.List;
import nephele.engine.level.Camera;
import nephele.engine.math.Vec3;
import nephele.engine.scene.View;

/** A camera: a small pyramid of its picture; if selected, its path and the line to its target. */
final class CameraSymbol {
    private static final double LENGTH_METRES = 0.5;
    private static final double ASPECT = 16.0 / 9;

    /** A path is drawn with at most about so many lines. */
    private static final int MOST_PATH_LINES = 500;

    private CameraSymbol() {}

    static void add(Camera camera, Wires wires) {
        View view = View.ofCamera(camera, 0, ASPECT);
        Vec3 eye = view.eye();
        Vec3 middle = eye.addScaled(-LENGTH_METRES, view.back());
        Vec3 right = view.right().scaled(LENGTH_METRES * view.projection().tanHalfWidth());
        Vec3 up = view.up().scaled(LENGTH_METRES * view.projection().tanHalfHeight());
        List<Vec3> corners = List.of(
                middle.plus(right).plus(up),
                middle.minus(right).plus(up),
                middle.minus(right).minus(up),
                middle.plus(right).minus(up));
        wires.outline(corners);
        corners.forEach(corner -> wires.line(eye, corner));
        Vec3 top = middle.addScaled(1.4, up);
        wires.line(corners.get(0), top);
        wires.line(corners.get(1), top);
    }

    static void addPath(Camera camera, Wires wires) {
        List<Camera.Waypoint> path = camera.path();
        if (path.isEmpty()) {
            wires.line(camera.position(), camera.target());
            return;
        }
        int step = 1 + path.size() / MOST_PATH_LINES;
        for (int i = step; i < path.size(); i += step) {
            wires.line(path.get(i - step).position(), path.get(i).position());
        }
    }
}
