package nephele.editor.tool;

import java.util.Optional;
import nephele.editor.tool.ToolOptions.Snapping;
import nephele.engine.level.Brush;
import nephele.engine.math.Vec3;

/** Snapping as the tool options say: to the grid, and to the vertices of brushes near the pointer. */
public final class Snap {
    private static final double VERTEX_PIXELS = 8;

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
        if (context.options().snapping().contains(Snapping.VERTEX)) {
            Optional<Vec3> vertex = vertex(context, pointer);
            if (vertex.isPresent()) {
                return vertex.get();
            }
        }
        return offset(context, at);
    }

    private static boolean isToGrid(ToolContext context) {
        return context.options().snapping().contains(Snapping.GRID);
    }

    private static Optional<Vec3> vertex(ToolContext context, Pointer pointer) {
        Vec3 nearest = null;
        double least = VERTEX_PIXELS;
        for (Brush brush : context.shapes().brushes()) {
            for (Vec3 vertex : brush.shape().vertices()) {
                double pixels = ScreenDistance.toPoint(pointer, vertex);
                if (pixels < least) {
                    least = pixels;
                    nearest = vertex;
                }
            }
        }
        return Optional.ofNullable(nearest);
    }
}
