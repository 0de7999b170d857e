package nephele.editor.tool.measure;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import nephele.editor.pane.Mark;
import nephele.editor.pane.Mark.Visibility;
import nephele.editor.pane.MarkColour;
import nephele.editor.text.Words;
import nephele.editor.tool.PointedPlace;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Snap;
import nephele.editor.tool.Tool;
import nephele.editor.tool.ToolContext;
import nephele.editor.tool.ToolEntry;
import nephele.engine.math.Vec3;

/** Measures the distance between two places, vertices or points of the grid; the measure stays until the next one. */
public final class MeasureTool implements Tool {
    public static final ToolEntry ENTRY = new ToolEntry(
            "measure",
            Words.of("Measure", "Medir", "Medir"),
            Words.of(
                    "Drag from one place to another for their distance",
                    "Arraste de um lugar a outro para ver a distância",
                    "Arrasta de um sítio a outro para ver a distância"),
            "L",
            MeasureTool::new);

    private final ToolContext context;
    /** The place under the pointer; {@code null} over nothing. */
    private Vec3 hovered;
    /** {@code null} without a measure. */
    private Vec3 from;

    private Vec3 to;
    private boolean isPressed;

    public MeasureTool(ToolContext context) {
        this.context = context;
    }

    @Override
    public void moved(Pointer pointer) {
        hovered = under(pointer).orElse(null);
    }

    @Override
    public void left() {
        hovered = null;
    }

    @Override
    public void pressed(Pointer pointer) {
        moved(pointer);
        from = hovered;
        to = hovered;
        isPressed = from != null;
    }

    @Override
    public void dragged(Pointer pointer) {
        moved(pointer);
        if (isPressed && hovered != null) {
            to = hovered;
        }
    }

    @Override
    public void released(Pointer pointer) {
        dragged(pointer);
        isPressed = false;
        if (from != null && from.equals(to)) {
            from = null;
        }
    }

    @Override
    public void cancel() {
        from = null;
        isPressed = false;
        hovered = null;
    }

    @Override
    public List<Mark> marks() {
        if (from == null) {
            return hovered == null ? List.of() : List.of(new Mark.Handle(hovered, MarkColour.GUIDE));
        }
        return List.of(
                new Mark.Line(from, to, MarkColour.GUIDE, Visibility.ALWAYS),
                new Mark.Handle(from, MarkColour.GUIDE),
                new Mark.Handle(to, MarkColour.GUIDE),
                new Mark.Label(from.lerp(to, 0.5), text(), MarkColour.GUIDE));
    }

    private String text() {
        Vec3 by = to.minus(from);
        return String.format(
                Locale.ROOT,
                "%.3f m  dx %.3f  dy %.3f  dz %.3f",
                by.length(),
                by.x() + 0.0,
                by.y() + 0.0,
                by.z() + 0.0);
    }

    @Override
    public Words hint() {
        return from == null ? ENTRY.description() : Words.same(text());
    }

    /** Returns the vertex that is near the pointer in the picture, or else a point of the grid; empty over nothing. */
    private Optional<Vec3> under(Pointer pointer) {
        return Snap.vertex(context, pointer, Set.of()).or(() -> PointedPlace.under(context, pointer)
                .map(place -> place.snapped(context).point()));
    }
}
