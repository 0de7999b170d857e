package nephele.editor.tool.extrude;

import java.util.List;
import java.util.Optional;
import nephele.editor.brush.BrushEdit;
import nephele.editor.brush.FaceExtrude;
import nephele.editor.document.Snapshot;
import nephele.editor.mark.Mark;
import nephele.editor.mark.MarkColour;
import nephele.editor.pick.Picker;
import nephele.editor.record.EntityRef;
import nephele.editor.text.Words;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Pointer.Modifier;
import nephele.editor.tool.Snap;
import nephele.editor.tool.Tool;
import nephele.editor.tool.ToolContext;
import nephele.editor.tool.ToolEntry;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;

/** Moves the face under the pointer along its normal; with Control, the part that is added or cut off is a new brush. */
public final class ExtrudeTool implements Tool {
    public static final ToolEntry ENTRY = new ToolEntry(
            "extrude",
            Words.of("Extrude", "Extrudar", "Extrudir"),
            Words.of(
                    "Drag a face along its normal; Control: as a new brush",
                    "Arraste uma face ao longo da sua normal; Control: como um bloco novo",
                    "Arrasta uma face ao longo da sua normal; Control: como um bloco novo"),
            "X",
            "extrude",
            ExtrudeTool::new);

    private static final Words EXTRUDE = Words.of("Extrude face", "Extrudar face", "Extrudir face");

    private final ToolContext context;
    private FaceUnderPointer hovered;
    /** The face of the drag in progress; {@code null} without one. */
    private FaceUnderPointer taken;

    private Pointer start;

    public ExtrudeTool(ToolContext context) {
        this.context = context;
    }

    @Override
    public void moved(Pointer pointer) {
        hovered = FaceUnderPointer.of(context, pointer).orElse(null);
    }

    @Override
    public void pressed(Pointer pointer) {
        moved(pointer);
        taken = hovered;
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
        EntityRef ref = new EntityRef(Picker.SOLIDS, taken.brush().solidId());
        context.document().drag(before -> {
            Optional<Solid> solid =
                    context.document().entities().find(before.level(), ref).map(Solid.class::cast);
            return solid.map(found -> isNew ? withNew(before, found, metres) : grown(found, metres))
                    .map(edit -> replaced(before, ref, edit))
                    .orElse(before);
        });
    }

    private BrushEdit<List<Solid>> grown(Solid solid, double metres) {
        return FaceExtrude.extruded(solid, taken.index(), metres).map(List::of);
    }

    private BrushEdit<List<Solid>> withNew(Snapshot before, Solid solid, double metres) {
        String id = context.document().entities().freshId(before.level(), Picker.SOLIDS, solid.id());
        return FaceExtrude.extrudedAsNew(solid, taken.index(), metres, id);
    }

    private Snapshot replaced(Snapshot before, EntityRef ref, BrushEdit<List<Solid>> edit) {
        context.status(edit.refusal().map(why -> why.words()).orElse(Words.NONE));
        return edit.result()
                .map(solids -> before.with((Level) context.document()
                        .entities()
                        .replaced(
                                before.level(),
                                ref,
                                solids.stream().map(Record.class::cast).toList())))
                .orElse(before);
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
        return List.of(
                new Mark.Polygon(hovered.face().polygon(), MarkColour.HOVERED, Mark.Visibility.HIDDEN_BY_SURFACES));
    }

    @Override
    public Words hint() {
        return ENTRY.description();
    }
}
