package nephele.editor.tool.extrude;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import nephele.editor.brush.BrushEdit;
import nephele.editor.brush.FaceExtrude;
import nephele.editor.document.Selection;
import nephele.editor.document.Snapshot;
import nephele.editor.mark.Mark;
import nephele.editor.mark.MarkColour;
import nephele.editor.pick.Picker;
import nephele.editor.record.Entities;
import nephele.editor.text.Words;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Pointer.Modifier;
import nephele.editor.tool.Snap;
import nephele.editor.tool.Tool;
import nephele.editor.tool.ToolContext;
import nephele.editor.tool.ToolEntry;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;

/**
 * Moves the face under the pointer along its normal, with those in its plane that are selected or belong to selected
 * brushes if it is one of them. With Control, the part that is added or cut off is a new brush; Shift selects faces.
 */
public final class ExtrudeTool implements Tool {
    public static final ToolEntry ENTRY = new ToolEntry(
            "extrude",
            Words.of("Extrude", "Extrudar", "Extrudir"),
            Words.of(
                    "Drag a face along its normal; Shift+click: several; Control: as a new brush",
                    "Arraste uma face pela normal; Shift+clique: várias; Control: bloco novo",
                    "Arrasta uma face pela normal; Shift+clique: várias; Control: bloco novo"),
            "X",
            "extrude",
            ExtrudeTool::new);

    private static final Words EXTRUDE = Words.of("Extrude face", "Extrudar face", "Extrudir face");

    private final ToolContext context;
    private FaceUnderPointer hovered;
    /** The face of the drag in progress; {@code null} without one. */
    private FaceUnderPointer taken;

    /** The faces that the drag moves, the taken one first. */
    private List<MovedFace> moving = List.of();

    private Pointer start;

    public ExtrudeTool(ToolContext context) {
        this.context = context;
    }

    @Override
    public void moved(Pointer pointer) {
        hovered = FaceUnderPointer.of(context, pointer).orElse(null);
    }

    @Override
    public void left() {
        hovered = null;
    }

    @Override
    public void pressed(Pointer pointer) {
        moved(pointer);
        if (hovered != null && pointer.isHeld(Modifier.SHIFT)) {
            context.document().select(context.document().selection().toggled(hovered.ref()));
            return;
        }
        taken = hovered;
        moving = taken == null ? List.of() : MovedFace.with(context, taken);
        start = pointer;
    }

    @Override
    public void dragged(Pointer pointer) {
        if (taken != null) {
            taken.between(start, pointer)
                    .map(metres -> Snap.length(context, metres))
                    .ifPresent(metres -> show(metres, pointer.isHeld(Modifier.CONTROL)));
        }
    }

    private void show(double metres, boolean isNew) {
        if (metres == 0) {
            context.document().cancelDrag();
            return;
        }
        context.document().drag(before -> {
            BrushEdit<Level> edit = BrushEdit.done(before.level());
            for (MovedFace face : moving) {
                edit = edit.flatMap(level -> moved(level, face, metres, isNew));
            }
            context.status(edit.refusal().map(why -> why.words()).orElse(Words.NONE));
            return edit.result().map(before::with).orElse(before);
        });
    }

    private BrushEdit<Level> moved(Level level, MovedFace face, double metres, boolean isNew) {
        Entities entities = context.document().entities();
        Optional<Solid> found = entities.find(level, face.solid()).map(Solid.class::cast);
        if (found.isEmpty()) {
            return BrushEdit.done(level);
        }
        BrushEdit<List<Solid>> edit = isNew
                ? FaceExtrude.extrudedAsNew(
                        found.get(),
                        face.index(),
                        metres,
                        entities.freshId(level, Picker.SOLIDS, face.solid().id()))
                : FaceExtrude.extruded(found.get(), face.index(), metres).map(List::of);
        return edit.map(solids -> new Snapshot(level, Selection.NONE)
                .replaced(Map.of(
                        face.solid(), solids.stream().map(Record.class::cast).toList()))
                .level());
    }

    @Override
    public void released(Pointer pointer) {
        if (taken != null) {
            context.document().commitDrag(EXTRUDE);
            taken = null;
            moved(pointer);
        }
    }

    @Override
    public void cancel() {
        context.document().cancelDrag();
        taken = null;
        hovered = null;
    }

    @Override
    public List<Mark> marks() {
        if (taken != null || hovered == null) {
            return List.of();
        }
        return MovedFace.with(context, hovered).stream()
                .map(face ->
                        (Mark) new Mark.Polygon(face.polygon(), MarkColour.HOVERED, Mark.Visibility.HIDDEN_BY_SURFACES))
                .toList();
    }

    @Override
    public Words hint() {
        return ENTRY.description();
    }
}
