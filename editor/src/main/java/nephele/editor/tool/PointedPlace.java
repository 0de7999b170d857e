package nephele.editor.tool;

import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import nephele.editor.document.Grid;
import nephele.editor.document.Picker;
import nephele.editor.record.EntityRef;
import nephele.editor.tool.ToolOptions.Snapping;
import nephele.engine.math.Vec3;

/**
 * The place under the pointer on the nearest visible surface of a solid, or on the ground y = 0 where there is none; in
 * a plan that sees the ground edge-on, in the plane through the origin.
 *
 * @param normal outward, unit length
 */
public record PointedPlace(Vec3 point, Vec3 normal) {
    private static final double PER_NANOMETRE = 1e9;
    private static final Vec3 UP = new Vec3(0, 1, 0);

    /** Returns the place under the pointer, without snapping; empty if the ray of sight meets nothing. */
    public static Optional<PointedPlace> under(ToolContext context, Pointer pointer) {
        return under(context, pointer, entity -> false);
    }

    /** Returns the place under the pointer on what is not ignored. */
    public static Optional<PointedPlace> under(ToolContext context, Pointer pointer, Predicate<EntityRef> isIgnored) {
        Optional<Picker.Pick> surface = context.picker().surfaces(pointer.ray()).stream()
                .filter(pick -> !isIgnored.test(pick.entity()))
                .findFirst();
        if (surface.isPresent()) {
            return surface.map(pick -> new PointedPlace(pick.point(), pick.normal()));
        }
        boolean isEdgeOn = pointer.isPlan() && pointer.camera().forward().y() == 0;
        Vec3 plane = isEdgeOn ? pointer.camera().forward() : UP;
        return pointer.onPlane(Vec3.ZERO, plane).map(point -> new PointedPlace(point, UP));
    }

    /** Returns the point of the grid near this one, on the same surface; this one if the options snap to no grid. */
    public PointedPlace snapped(ToolContext context) {
        boolean isToGrid = Snap.is(context, Snapping.GRID) || Snap.is(context, Snapping.ABSOLUTE);
        return isToGrid ? snapped(context.grid()) : this;
    }

    /** Returns the vertex near the pointer if the options snap to vertices, else the snapped place. */
    public PointedPlace snapped(ToolContext context, Pointer pointer) {
        return (Snap.is(context, Snapping.VERTEX) ? Snap.vertex(context, pointer, Set.of()) : Optional.<Vec3>empty())
                .map(vertex -> new PointedPlace(vertex, normal))
                .orElseGet(() -> snapped(context));
    }

    private PointedPlace snapped(Grid grid) {
        Vec3 nearest = grid.snapped(point);
        double off = nearest.minus(point).dot(normal);
        return new PointedPlace(cleaned(nearest.addScaled(-off, normal)), normal);
    }

    /** Returns a vector without the rounding that a file would show as 15 digits; it changes by a nanometre at most. */
    public static Vec3 cleaned(Vec3 v) {
        return new Vec3(cleaned(v.x()), cleaned(v.y()), cleaned(v.z()));
    }

    private static double cleaned(double value) {
        return Math.rint(value * PER_NANOMETRE) / PER_NANOMETRE + 0.0;
    }
}
