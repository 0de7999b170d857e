package nephele.editor.tool.transform;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import nephele.editor.document.Notes;
import nephele.editor.document.Snapshot;
import nephele.editor.mark.Mark;
import nephele.editor.pick.EntityBounds;
import nephele.editor.record.EntityRef;
import nephele.editor.text.Words;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.ScreenDistance;
import nephele.editor.tool.Tool;
import nephele.editor.tool.ToolContext;
import nephele.editor.tool.ToolEntry;
import nephele.editor.tool.select.SelectTool;
import nephele.engine.level.Level;
import nephele.engine.math.Aabb;

/** Changes the selection by the grips of a gizmo; elsewhere the pointer selects as with the select tool. */
public final class TransformTool implements Tool {
    public static final ToolEntry MOVE = new ToolEntry(
            "move",
            Words.of("Move", "Mover", "Mover"),
            Words.of(
                    "Drag an arrow or a corner to move along an axis or in a plane",
                    "Arraste uma seta ou um canto para mover ao longo de um eixo ou em um plano",
                    "Arrasta uma seta ou um canto para mover ao longo de um eixo ou num plano"),
            "W",
            "move",
            context -> new TransformTool(context, Gizmo.MOVE));

    public static final ToolEntry ROTATE = new ToolEntry(
            "rotate",
            Words.of("Rotate", "Girar", "Rodar"),
            Words.of(
                    "Drag a ring to turn by 15°; Shift: by 5°",
                    "Arraste um anel para girar de 15° em 15°; Shift: de 5° em 5°",
                    "Arrasta um anel para rodar de 15° em 15°; Shift: de 5° em 5°"),
            "E",
            "rotate",
            context -> new TransformTool(context, Gizmo.ROTATE));

    public static final ToolEntry SCALE = new ToolEntry(
            "scale",
            Words.of("Scale", "Escalar", "Dimensionar"),
            Words.of(
                    "Drag a handle of a side to stretch, of a corner to scale all sides",
                    "Arraste a alça de um lado para esticar, a de um canto para escalar todos os lados",
                    "Arrasta a pega de um lado para esticar, a de um canto para dimensionar todos os lados"),
            "R",
            "scale",
            context -> new TransformTool(context, Gizmo.SCALE));

    private final ToolContext context;
    private final Gizmo gizmo;
    private final Tool select;
    /** The last pointer event; the gizmo has the size of its pane. */
    private Pointer last;

    private String hovered = "";
    /** The drag of a grip; {@code null} without one. */
    private GripDrag drag;

    private TransformTool(ToolContext context, Gizmo gizmo) {
        this.context = context;
        this.gizmo = gizmo;
        select = new SelectTool(context);
    }

    @Override
    public void moved(Pointer pointer) {
        last = pointer;
        hovered = under(pointer).map(Grip::name).orElse("");
        select.moved(pointer);
    }

    @Override
    public void left() {
        hovered = "";
    }

    @Override
    public void pressed(Pointer pointer) {
        moved(pointer);
        Optional<Grip> grip = under(pointer);
        if (grip.isPresent()) {
            drag = new GripDrag(context, grip.get().constraint(), pointer);
        } else {
            select.pressed(pointer);
        }
    }

    private Optional<Grip> under(Pointer pointer) {
        return grips(pointer).stream()
                .filter(grip -> grip.pixelsFrom(pointer) < ScreenDistance.REACH_PIXELS)
                .min(Comparator.comparingDouble(grip -> grip.pixelsFrom(pointer)));
    }

    private List<Grip> grips(Pointer pointer) {
        Aabb bounds = bounds();
        if (bounds.isEmpty()) {
            return List.of();
        }
        double metresPerPixel = pointer.camera().metresPerPixel(bounds.centre(), pointer.size());
        List<Grip> grips = new ArrayList<>(gizmo.grips(bounds, metresPerPixel));
        grips.removeIf(grip ->
                pointer.isPlan() && !grip.constraint().isUsable(pointer.camera().forward()));
        return grips;
    }

    private Aabb bounds() {
        Snapshot now = context.document().now();
        Aabb bounds = Aabb.EMPTY;
        for (EntityRef ref : Notes.unlocked(now.level(), now.selection().entities())) {
            bounds = context.document()
                    .entities()
                    .find(now.level(), ref)
                    .map(EntityBounds::of)
                    .orElse(Aabb.EMPTY)
                    .union(bounds);
        }
        return bounds;
    }

    @Override
    public void dragged(Pointer pointer) {
        last = pointer;
        if (drag == null) {
            select.dragged(pointer);
            return;
        }
        drag.change(pointer).ifPresent(change -> context.document()
                .drag(before -> before.with((Level) context.document()
                        .entities()
                        .changed(
                                before.level(),
                                Notes.unlocked(
                                        before.level(), before.selection().entities()),
                                change))));
    }

    @Override
    public void released(Pointer pointer) {
        if (drag == null) {
            select.released(pointer);
        } else {
            context.document().commitDrag(entry().title());
            drag = null;
        }
    }

    @Override
    public void cancel() {
        select.cancel();
        context.document().cancelDrag();
        drag = null;
    }

    @Override
    public List<Mark> marks() {
        List<Mark> marks = new ArrayList<>(select.marks());
        if (last != null) {
            for (Grip grip : grips(last)) {
                marks.addAll(grip.marks(grip.name().equals(hovered)));
            }
        }
        return marks;
    }

    @Override
    public Words hint() {
        return entry().description();
    }

    private ToolEntry entry() {
        return switch (gizmo) {
            case MOVE -> MOVE;
            case ROTATE -> ROTATE;
            case SCALE -> SCALE;
        };
    }
}
