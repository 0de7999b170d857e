package nephele.editor.tool;

import java.util.Optional;
import java.util.Set;
import nephele.editor.pane.PaneCamera;
import nephele.editor.pane.PaneCamera.PanePoint;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneKind;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/**
 * A pointer event in a pane, and where in the world the pointer then is: on a plane, along a line, near a point.
 *
 * @param x pixels from the left border of the pane
 * @param y pixels from its upper border
 * @param clicks 2 for a double click
 */
public record Pointer(
        PaneKind kind, PaneCamera camera, PaneSize size, double x, double y, Set<Modifier> modifiers, int clicks) {
    /** The greatest distance of the pointer from a handle or line that it picks, in pixels. */
    public static final double REACH_PIXELS = 8;

    private static final double GRAZING = 1e-3;

    /** A key that is held. */
    public enum Modifier {
        SHIFT,
        CONTROL,
        ALT
    }

    /** Returns the ray of sight through the pointer. */
    public Ray ray() {
        return camera.ray(x, y, size);
    }

    public boolean isHeld(Modifier modifier) {
        return modifiers.contains(modifier);
    }

    public boolean isPlan() {
        return kind != PaneKind.PERSPECTIVE;
    }

    /** Returns where the ray of sight meets a plane; empty if it is behind or at a grazing angle. */
    public Optional<Vec3> onPlane(Vec3 point, Vec3 normal) {
        Ray ray = ray();
        Vec3 direction = new Vec3(ray.directionX(), ray.directionY(), ray.directionZ());
        double rate = direction.dot(normal);
        if (Math.abs(rate) < GRAZING) {
            return Optional.empty();
        }
        // Differences from the plane's point keep the precision far from the origin of a plan's distant ray.
        Vec3 origin = new Vec3(ray.originX(), ray.originY(), ray.originZ());
        double distance = point.minus(origin).dot(normal) / rate;
        return distance < 0 ? Optional.empty() : Optional.of(ray.at(distance));
    }

    /** Returns the distance along a line, in units of {@code direction}, of its place nearest to the ray of sight. */
    public Optional<Double> alongLine(Vec3 point, Vec3 direction) {
        Ray ray = ray();
        Vec3 sight = new Vec3(ray.directionX(), ray.directionY(), ray.directionZ());
        Vec3 across = sight.cross(direction);
        Vec3 normal = across.cross(sight);
        double rate = direction.dot(normal);
        if (Math.abs(rate) < GRAZING * direction.dot(direction)) {
            return Optional.empty();
        }
        Vec3 origin = new Vec3(ray.originX(), ray.originY(), ray.originZ());
        return Optional.of(origin.minus(point).dot(normal) / rate);
    }

    /**
     * Returns the normal of the plane in which a free drag moves: the direction of sight of a plan, upwards in a
     * perspective view, or the horizontal axis nearest to the direction of sight if it is nearly level.
     */
    public Vec3 dragPlaneNormal() {
        Vec3 forward = camera.forward();
        if (isPlan()) {
            return forward.negated();
        }
        if (Math.abs(forward.y()) > 0.25) {
            return new Vec3(0, 1, 0);
        }
        return Math.abs(forward.x()) > Math.abs(forward.z()) ? new Vec3(1, 0, 0) : new Vec3(0, 0, 1);
    }

    /** Returns true if a handle at a point is near enough in the picture to be picked. */
    public boolean reaches(Vec3 point) {
        return pixelsTo(point) < REACH_PIXELS;
    }

    /** Returns the distance to a point in the picture; infinite to one behind the camera. */
    public double pixelsTo(Vec3 point) {
        return pixelsTo(point, point);
    }

    /** Returns the distance to a line from point to point in the picture; infinite if an end is behind the camera. */
    public double pixelsTo(Vec3 from, Vec3 to) {
        Optional<PanePoint> a = camera.project(from, size);
        Optional<PanePoint> b = camera.project(to, size);
        if (a.isEmpty() || b.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        double alongX = b.get().x() - a.get().x();
        double alongY = b.get().y() - a.get().y();
        double fromX = x - a.get().x();
        double fromY = y - a.get().y();
        double squared = alongX * alongX + alongY * alongY;
        double fraction = squared > 0 ? Math.max(0, Math.min(1, (fromX * alongX + fromY * alongY) / squared)) : 0;
        return Math.hypot(fromX - fraction * alongX, fromY - fraction * alongY);
    }
}
