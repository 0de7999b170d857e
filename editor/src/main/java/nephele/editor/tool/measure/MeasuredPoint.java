package nephele.editor.tool.measure;

import java.util.Optional;
import java.util.Set;
import nephele.editor.tool.PointedPlace;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Snap;
import nephele.editor.tool.ToolContext;
import nephele.engine.math.Vec3;

/** The place that a measure takes under the pointer: a vertex that is near in the picture, else one of the grid. */
final class MeasuredPoint {
    private MeasuredPoint() {}

    /** Returns the place; empty if the pointer is over nothing. */
    static Optional<Vec3> under(ToolContext context, Pointer pointer) {
        return Snap.vertex(context, pointer, Set.of()).or(() -> PointedPlace.under(context, pointer)
                .map(place -> place.snapped(context).point()));
    }
}
