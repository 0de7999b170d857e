package nephele.editor.tool.measure;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import nephele.editor.pane.PaneCamera.PanePoint;
import nephele.editor.pick.Picker;
import nephele.editor.record.EntityRef;
import nephele.editor.tool.PointedPlace;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.ToolContext;
import nephele.engine.level.Brush;
import nephele.engine.math.Vec3;

/** The place that a measure takes under the pointer: a vertex that is near in the picture, else one of the grid. */
final class MeasuredPoint {
    private static final double NEAR_PIXELS = 8;

    private MeasuredPoint() {}

    /** Returns the place; empty if the pointer is over nothing. */
    static Optional<Vec3> under(ToolContext context, Pointer pointer) {
        return vertex(context, pointer).or(() -> PointedPlace.under(context, pointer)
                .map(place -> place.snapped(context).point()));
    }

    /** Returns the vertex nearest to the pointer; of those that appear at the same pixel, the nearest to the eye. */
    private static Optional<Vec3> vertex(ToolContext context, Pointer pointer) {
        Set<String> hidden = new HashSet<>(context.document().level().editor().hidden());
        Vec3 best = null;
        double bestPixels = NEAR_PIXELS;
        double bestDepth = Double.POSITIVE_INFINITY;
        for (Brush brush : context.shapes().brushes()) {
            if (hidden.contains(new EntityRef(Picker.SOLIDS, brush.solidId()).text())) {
                continue;
            }
            for (Vec3 vertex : brush.shape().vertices()) {
                Optional<PanePoint> seen = pointer.camera().project(vertex, pointer.size());
                double pixels = seen.map(p -> Math.hypot(p.x() - pointer.x(), p.y() - pointer.y()))
                        .orElse(Double.POSITIVE_INFINITY);
                double depth = seen.map(PanePoint::depthMetres).orElse(Double.POSITIVE_INFINITY);
                boolean isSamePixel = Math.abs(pixels - bestPixels) < 0.5;
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
