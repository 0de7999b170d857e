package nephele.editor.tool;

import java.util.Optional;
import nephele.editor.pane.PaneCamera.PanePoint;
import nephele.engine.math.Vec3;

/** Distances in the picture, in pixels; infinite to what is behind the camera. */
public final class ScreenDistance {
    /** The greatest distance of the pointer from a handle or line that it picks, in pixels. */
    public static final double REACH_PIXELS = 8;

    private ScreenDistance() {}

    /** Returns the distance between the pointer and a point. */
    public static double toPoint(Pointer pointer, Vec3 point) {
        return toSegment(pointer, point, point);
    }

    /** Returns the distance between the pointer and a line from point to point. */
    public static double toSegment(Pointer pointer, Vec3 from, Vec3 to) {
        Optional<PanePoint> a = pointer.camera().project(from, pointer.size());
        Optional<PanePoint> b = pointer.camera().project(to, pointer.size());
        if (a.isEmpty() || b.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        double alongX = b.get().x() - a.get().x();
        double alongY = b.get().y() - a.get().y();
        double x = pointer.x() - a.get().x();
        double y = pointer.y() - a.get().y();
        double squared = alongX * alongX + alongY * alongY;
        double share = squared > 0 ? Math.max(0, Math.min(1, (x * alongX + y * alongY) / squared)) : 0;
        return Math.hypot(x - share * alongX, y - share * alongY);
    }
}
