package nephele.editor.tool;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import nephele.editor.document.Picker;
import nephele.editor.pane.PaneCamera.PanePoint;
import nephele.editor.record.EntityRef;
import nephele.editor.tool.ToolOptions.Snapping;
import nephele.engine.level.Brush;
import nephele.engine.math.Vec3;

/** Snapping of lengths and places as the tool options say; {@link SnappedMove} snaps displacements of entities. */
public final class Snap {
    private static final double SAME_PIXEL = 0.5;

    private Snap() {}

    /** Returns the nearest multiple of the grid's step, or the length itself if nothing snaps to the grid. */
    public static double length(ToolContext context, double metres) {
        return isToGrid(context) ? context.grid().snapped(metres) : metres;
    }

    /** Returns a difference of places whose components are lengths that are snapped. */
    public static Vec3 offset(ToolContext context, Vec3 by) {
        return isToGrid(context) ? context.grid().snapped(by) : by;
    }

    /** Returns the place that a pointer at a place means: a vertex under the pointer, or a place on the grid. */
    public static Vec3 place(ToolContext context, Pointer pointer, Vec3 at) {
        Optional<Vec3> vertex = is(context, Snapping.VERTEX) ? vertex(context, pointer, Set.of()) : Optional.empty();
        if (vertex.isPresent()) {
            return vertex.get();
        }
        return is(context, Snapping.SURFACE)
                ? onSurface(context, pointer).orElseGet(() -> offset(context, at))
                : offset(context, at);
    }

    static boolean is(ToolContext context, Snapping target) {
        return context.options().snapping().contains(target);
    }

    private static boolean isToGrid(ToolContext context) {
        return is(context, Snapping.GRID) || is(context, Snapping.ABSOLUTE);
    }

    private static Optional<Vec3> onSurface(ToolContext context, Pointer pointer) {
        if (pointer.isPlan()) {
            return onEdge(context, pointer);
        }
        return context.picker().surfaces(pointer.ray()).stream().findFirst().map(pick -> new PointedPlace(
                        pick.point(), pick.normal())
                .snapped(context)
                .point());
    }

    /** Returns the place on the edge of a brush that is nearest to the pointer in the picture of a plan. */
    private static Optional<Vec3> onEdge(ToolContext context, Pointer pointer) {
        Vec3 nearest = null;
        double least = Pointer.REACH_PIXELS;
        for (Brush brush : context.shapes().brushes()) {
            for (Brush.BrushFace face : brush.faces()) {
                for (int i = 0; i < face.polygon().size(); i++) {
                    Vec3 from = face.polygon().get(i);
                    Vec3 to = face.polygon().get((i + 1) % face.polygon().size());
                    double pixels = pointer.pixelsTo(from, to);
                    if (pixels < least) {
                        least = pixels;
                        nearest = along(pointer, from, to);
                    }
                }
            }
        }
        return Optional.ofNullable(nearest);
    }

    private static Vec3 along(Pointer pointer, Vec3 from, Vec3 to) {
        double fraction = pointer.alongLine(from, to.minus(from)).orElse(0.0);
        return PointedPlace.cleaned(from.lerp(to, Math.max(0, Math.min(1, fraction))));
    }

    /**
     * Returns the visible vertex nearest to the pointer; of those that appear at the same pixel, the nearest to the eye.
     *
     * @param ignored solids whose vertices do not count
     */
    public static Optional<Vec3> vertex(ToolContext context, Pointer pointer, Set<EntityRef> ignored) {
        Set<String> hidden = new HashSet<>(context.document().level().editor().hidden());
        Vec3 best = null;
        double bestPixels = Pointer.REACH_PIXELS;
        double bestDepth = Double.POSITIVE_INFINITY;
        for (Brush brush : context.shapes().brushes()) {
            EntityRef solid = new EntityRef(Picker.SOLIDS, brush.solidId());
            if (hidden.contains(solid.text()) || ignored.contains(solid)) {
                continue;
            }
            for (Vec3 vertex : brush.shape().vertices()) {
                Optional<PanePoint> projected = pointer.camera().project(vertex, pointer.size());
                double pixels = projected
                        .map(p -> Math.hypot(p.x() - pointer.x(), p.y() - pointer.y()))
                        .orElse(Double.POSITIVE_INFINITY);
                double depth = projected.map(PanePoint::depthMetres).orElse(Double.POSITIVE_INFINITY);
                boolean isSamePixel = Math.abs(pixels - bestPixels) < SAME_PIXEL;
                if (isSamePixel ? depth < bestDepth : pixels < bestPixels) {
                    best = vertex;
                    bestPixels = pixels;
                    bestDepth = depth;
                }
            }
        }
        return Optional.ofNullable(best);
    }
}
