package nephele.editor.tool.extrude;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import nephele.editor.brush.BrushEdit;
import nephele.editor.brush.FaceExtrude;
import nephele.editor.document.NoteEdits;
import nephele.editor.document.Picker;
import nephele.editor.document.Selection;
import nephele.editor.document.Selection.FaceRef;
import nephele.editor.document.Snapshot;
import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.text.Words;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Pointer.Modifier;
import nephele.editor.tool.Snap;
import nephele.editor.tool.Tool;
import nephele.editor.tool.ToolContext;
import nephele.editor.tool.ToolEntry;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

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
            ExtrudeTool::new);

    private static final Words EXTRUDE = Words.of("Extrude face", "Extrudar face", "Extrudir face");

    private static final double EDGE_ON = 1e-3;
    private static final double SAME_PLANE_METRES = 1e-6;
    private static final double SAME_NORMAL = 1e-9;

    /**
     * A face of a brush that the pointer can take.
     *
     * @param index in the order of {@code brush.faces()}
     * @param grabbed the place on the face at which the pointer takes it
     */
    private record FaceGrip(Brush brush, int index, Vec3 grabbed) {
        FaceRef ref() {
            return new FaceRef(new EntityRef(Picker.SOLIDS, brush.solidId()), face().name());
        }

        BrushFace face() {
            return brush.faces().get(index);
        }

        /** Returns the distance along the normal, metres, between where two pointers point. */
        Optional<Double> between(Pointer from, Pointer to) {
            Vec3 normal = face().plane().normal();
            return from.alongLine(grabbed, normal)
                    .flatMap(begin -> to.alongLine(grabbed, normal).map(end -> end - begin));
        }
    }

    private final ToolContext context;
    private FaceGrip hovered;
    /** The face of the drag in progress; {@code null} without one. */
    private FaceGrip taken;

    /** The faces that the drag moves, the taken one first. */
    private List<FaceGrip> moving = List.of();

    private Pointer start;

    public ExtrudeTool(ToolContext context) {
        this.context = context;
    }

    @Override
    public void moved(Pointer pointer) {
        hovered = under(pointer).orElse(null);
    }

    /**
     * Returns the face that an extrusion begins at. In a plan it is a side of the nearest brush, since the face in front
     * can move only along the direction of sight.
     */
    private Optional<FaceGrip> under(Pointer pointer) {
        Optional<Picker.Pick> solid = context.picker().along(pointer.ray()).stream()
                .filter(pick -> pick.entity().section().equals(Picker.SOLIDS))
                .findFirst();
        Optional<Brush> brush = solid.flatMap(pick -> context.shapes().brushes().stream()
                .filter(candidate -> candidate.solidId().equals(pick.entity().id()))
                .findFirst());
        if (brush.isEmpty()) {
            return Optional.empty();
        }
        return pointer.isPlan() ? side(brush.get(), pointer) : named(brush.get(), solid.get());
    }

    private static Optional<FaceGrip> named(Brush brush, Picker.Pick pick) {
        for (int i = 0; i < brush.faces().size(); i++) {
            if (brush.faces().get(i).name().equals(pick.face())) {
                return Optional.of(new FaceGrip(brush, i, pick.point()));
            }
        }
        return Optional.empty();
    }

    /** Returns the face nearest in the picture among those that the plan sees edge on. */
    private static Optional<FaceGrip> side(Brush brush, Pointer pointer) {
        Vec3 forward = pointer.camera().forward();
        FaceGrip nearest = null;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < brush.faces().size(); i++) {
            BrushFace face = brush.faces().get(i);
            double pixels = pixels(face, pointer);
            if (Math.abs(face.plane().normal().dot(forward)) < EDGE_ON && pixels < least) {
                least = pixels;
                nearest = new FaceGrip(brush, i, face.polygon().get(0));
            }
        }
        return Optional.ofNullable(nearest);
    }

    private static double pixels(BrushFace face, Pointer pointer) {
        List<Vec3> ring = face.polygon();
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < ring.size(); i++) {
            least = Math.min(least, pointer.pixelsTo(ring.get(i), ring.get((i + 1) % ring.size())));
        }
        return least;
    }

    /** Returns a face, and if it is selected those that are selected in its plane. */
    private List<FaceGrip> withSelectedInPlane(FaceGrip face) {
        List<FaceGrip> faces = new ArrayList<>();
        faces.add(face);
        if (isSelected(face.ref())) {
            for (Brush brush : context.shapes().brushes()) {
                if (brush != face.brush() && isFree(brush)) {
                    addSelected(faces, brush, face);
                }
            }
        }
        return List.copyOf(faces);
    }

    private void addSelected(List<FaceGrip> faces, Brush brush, FaceGrip first) {
        for (int i = 0; i < brush.faces().size(); i++) {
            FaceGrip other = new FaceGrip(brush, i, first.grabbed());
            if (isSame(other.face().plane(), first.face().plane()) && isSelected(other.ref())) {
                faces.add(other);
            }
        }
    }

    private boolean isSelected(FaceRef face) {
        Selection selection = context.document().selection();
        return selection.faces().contains(face) || selection.contains(face.solid());
    }

    private boolean isFree(Brush brush) {
        EntityRef solid = new EntityRef(Picker.SOLIDS, brush.solidId());
        return !NoteEdits.free(context.document().level(), List.of(solid)).isEmpty();
    }

    private static boolean isSame(Plane a, Plane b) {
        return a.normal().dot(b.normal()) > 1 - SAME_NORMAL
                && Math.abs(a.distance() - b.distance()) < SAME_PLANE_METRES;
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
        moving = taken == null ? List.of() : withSelectedInPlane(taken);
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
            for (FaceGrip face : moving) {
                edit = edit.flatMap(level -> moved(level, face, metres, isNew));
            }
            context.status(edit.refusal().map(why -> why.words()).orElse(Words.NONE));
            return edit.result().map(before::with).orElse(before);
        });
    }

    private BrushEdit<Level> moved(Level level, FaceGrip face, double metres, boolean isNew) {
        Optional<Solid> found = Entities.LEVEL.find(level, face.ref().solid()).map(Solid.class::cast);
        if (found.isEmpty()) {
            return BrushEdit.done(level);
        }
        BrushEdit<List<Solid>> edit = isNew
                ? FaceExtrude.extrudedAsNew(
                        found.get(),
                        face.index(),
                        metres,
                        Entities.LEVEL.freshId(
                                level, Picker.SOLIDS, face.brush().solidId()))
                : FaceExtrude.extruded(found.get(), face.index(), metres).map(List::of);
        return edit.map(solids -> new Snapshot(level, Selection.NONE)
                .replaced(Map.of(
                        face.ref().solid(),
                        solids.stream().map(Record.class::cast).toList()))
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
        return withSelectedInPlane(hovered).stream()
                .map(face -> (Mark)
                        new Mark.Polygon(face.face().polygon(), MarkColour.HOVERED, Mark.Visibility.HIDDEN_BY_SURFACES))
                .toList();
    }

    @Override
    public Words hint() {
        return ENTRY.description();
    }
}
