package nephele.editor.tool;

import java.util.Optional;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/** Maps the pointer to places: on a plane, along a line, and in the plane that a pane shows best. */
public final class PointerDrag {
    private static final double GRAZING = 1e-3;

    private PointerDrag() {}

    /** Returns where the ray of sight meets a plane; empty if it is behind or at a grazing angle. */
    public static Optional<Vec3> onPlane(Pointer pointer, Vec3 point, Vec3 normal) {
        Ray ray = pointer.ray();
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
    public static Optional<Double> alongLine(Pointer pointer, Vec3 point, Vec3 direction) {
        Ray ray = pointer.ray();
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
    public static Vec3 planeNormal(Pointer pointer) {
        Vec3 forward = pointer.camera().forward();
        if (pointer.isPlan()) {
            return forward.negated();
        }
        if (Math.abs(forward.y()) > 0.25) {
            return new Vec3(0, 1, 0);
        }
        return Math.abs(forward.x()) > Math.abs(forward.z()) ? new Vec3(1, 0, 0) : new Vec3(0, 0, 1);
    }
}
