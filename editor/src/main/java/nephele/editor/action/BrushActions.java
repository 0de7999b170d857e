package nephele.editor.action;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.brush.BrushBoolean;
import nephele.editor.brush.BrushCheck;
import nephele.editor.brush.BrushEdit;
import nephele.editor.brush.BrushHollow;
import nephele.editor.brush.BrushShapes;
import nephele.editor.brush.BrushStyle;
import nephele.editor.brush.BrushText;
import nephele.editor.brush.RoomSides;
import nephele.editor.brush.ShapeOptions;
import nephele.editor.document.Document;
import nephele.editor.document.Notes;
import nephele.editor.document.Selection;
import nephele.editor.document.Snapshot;
import nephele.editor.paint.MaterialLibrary;
import nephele.editor.pick.EntityBounds;
import nephele.editor.pick.Picker;
import nephele.editor.record.EntityRef;
import nephele.editor.session.EditorSession;
import nephele.editor.text.Words;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** Making brushes and changing several at once. */
final class BrushActions {
    private static final Words DRAW = Words.of("Draw Brush", "Desenhar bloco", "Desenhar bloco");
    private static final Words HOLLOW = Words.of("Hollow", "Esvaziar", "Esvaziar");
    private static final Words SUBTRACT = Words.of("Subtract", "Subtrair", "Subtrair");
    private static final Words MERGE = Words.of("Merge", "Unir", "Unir");
    private static final Words NOTCH = Words.of(
            "Merged; the brush is convex, so it fills the gaps that were between them",
            "Unidos; o bloco é convexo, por isso preenche os vãos que havia entre eles",
            "Unidos; o bloco é convexo, por isso preenche os vãos que havia entre eles");
    private static final Words NO_SHAPE = Words.of(
            "there is no shape '%s': box, wedge, stairs, arch, cylinder, room",
            "não há a forma '%s': box, wedge, stairs, arch, cylinder, room",
            "não há a forma '%s': box, wedge, stairs, arch, cylinder, room");

    static final List<EditorAction> ALL = List.of(
            EditorAction.of("brush", DRAW, Menu.BRUSH, List.of(), BrushActions::draw)
                    .taking("shape", "min", "max", "id", "wall", "steps", "material"),
            EditorAction.of("hollow", HOLLOW, Menu.BRUSH, List.of("Ctrl+Alt+H"), BrushActions::hollow)
                    .taking("wall")
                    .when(BrushActions::hasSolids),
            EditorAction.of("subtract", SUBTRACT, Menu.BRUSH, List.of("Ctrl+Minus"), BrushActions::subtract)
                    .when(BrushActions::hasSolids),
            EditorAction.of("merge", MERGE, Menu.BRUSH, List.of("Ctrl+M"), BrushActions::merge)
                    .when(session -> solids(session).size() > 1));

    private BrushActions() {}

    private static boolean hasSolids(EditorSession session) {
        return session.document().selection().entities().stream()
                .anyMatch(ref -> ref.section().equals(Picker.SOLIDS));
    }

    private static List<Solid> solids(EditorSession session) {
        List<Solid> solids = new ArrayList<>();
        for (EntityRef ref : session.document().selection().entities()) {
            session.document()
                    .entities()
                    .find(session.document().level(), ref)
                    .filter(Solid.class::isInstance)
                    .ifPresent(entity -> solids.add((Solid) entity));
        }
        return solids;
    }

    /** Returns ids that neither the level nor an earlier call has used. */
    private static Supplier<String> freshIds(Document document, String wish) {
        Set<String> taken = new HashSet<>();
        return () -> {
            String id = document.entities().freshId(document.level(), Picker.SOLIDS, wish, taken);
            taken.add(id);
            return id;
        };
    }

    private static void draw(ActionCall call) throws ActionFailure {
        Vec3 min = call.vector("min");
        Vec3 max = call.vector("max");
        EditorSession session = call.session();
        Document document = call.session().document();
        ShapeOptions shape = shape(call);
        String wish = call.text("id").orElse(call.text("shape").orElse("box"));
        String material = call.text("material").orElse(session.options().material());
        session.options().material(material);
        BrushStyle style = session.options().style(document.level());
        Aabb box = Aabb.of(List.of(min, max));
        List<Solid> drawn = done(BrushShapes.drawn(box, shape, style, freshIds(document, wish)));
        List<Solid> made = shape instanceof ShapeOptions.Room
                ? RoomSides.named(drawn, box, side -> freshIds(document, wish + "-" + side)
                        .get())
                : drawn;
        document.edit(
                DRAW,
                null,
                before -> with(
                        document,
                        before.with(MaterialLibrary.STANDARD.including(before.level(), material)),
                        List.of(),
                        made));
    }

    private static ShapeOptions shape(ActionCall call) throws ActionFailure {
        double wall = call.number(
                "wall",
                BrushCheck.LEAST_THICKNESS_METRES,
                ActionCall.MOST,
                call.session().grid().stepMetres());
        int steps = call.whole("steps", 1, ShapeOptions.MOST_STEPS, 8);
        String typed = call.text("shape").orElse("box");
        return switch (typed) {
            case "box" -> new ShapeOptions.Box();
            case "wedge" -> new ShapeOptions.Wedge(null);
            case "stairs" -> new ShapeOptions.Stairs(null, steps);
            case "arch" -> new ShapeOptions.Arch(steps, wall);
            case "cylinder" -> new ShapeOptions.Cylinder(steps * 2);
            case "room" -> new ShapeOptions.Room(wall);
            default -> throw new ActionFailure(NO_SHAPE.with(typed));
        };
    }

    private static <T> T done(BrushEdit<T> edit) throws ActionFailure {
        Optional<BrushText> refusal = edit.refusal();
        if (refusal.isPresent()) {
            throw new ActionFailure(refusal.get().words());
        }
        return edit.result().orElseThrow();
    }

    /** Returns the snapshot with solids replaced by others, which are selected. */
    private static Snapshot with(Document document, Snapshot before, List<Solid> gone, List<Solid> made) {
        List<Solid> solids = new ArrayList<>(before.level().solids());
        int at = gone.isEmpty() ? solids.size() : solids.indexOf(gone.get(0));
        solids.removeAll(gone);
        solids.addAll(Math.min(at, solids.size()), made);
        Level level = before.level().with(before.level().materials(), List.copyOf(solids));
        List<EntityRef> names = made.stream().map(BrushActions::ref).toList();
        List<EntityRef> removed = gone.stream()
                .map(BrushActions::ref)
                .filter(ref -> !names.contains(ref))
                .toList();
        return new Snapshot(Notes.without(level, removed), Selection.of(names));
    }

    private static EntityRef ref(Solid solid) {
        return new EntityRef(Picker.SOLIDS, solid.id());
    }

    private static void hollow(ActionCall call) throws ActionFailure {
        Document document = call.session().document();
        double wall = call.number(
                "wall",
                BrushCheck.LEAST_THICKNESS_METRES,
                ActionCall.MOST,
                call.session().grid().stepMetres());
        List<Solid> gone = solids(call.session());
        List<Solid> made = new ArrayList<>();
        for (Solid solid : gone) {
            made.addAll(done(BrushHollow.hollowed(solid, wall, freshIds(document, solid.id()))));
        }
        document.edit(HOLLOW, null, before -> with(document, before, gone, made));
    }

    /** Subtracts what is selected from every solid that it touches, and removes it. */
    private static void subtract(ActionCall call) throws ActionFailure {
        Document document = call.session().document();
        List<Solid> cutters = solids(call.session());
        List<Solid> gone = new ArrayList<>(cutters);
        List<Solid> made = new ArrayList<>();
        Supplier<String> ids = freshIds(document, "cut");
        for (Solid solid : document.level().solids()) {
            if (!cutters.contains(solid)) {
                List<Solid> left = remaining(solid, cutters, ids);
                if (!left.equals(List.of(solid))) {
                    gone.add(solid);
                    made.addAll(left);
                }
            }
        }
        document.edit(SUBTRACT, null, before -> with(document, before, gone, made));
    }

    private static List<Solid> remaining(Solid solid, List<Solid> cutters, Supplier<String> ids) throws ActionFailure {
        List<Solid> left = List.of(solid);
        for (Solid cutter : cutters) {
            if (EntityBounds.of((Record) cutter).overlaps(EntityBounds.of((Record) solid))) {
                List<Solid> next = new ArrayList<>();
                for (Solid piece : left) {
                    next.addAll(done(BrushBoolean.subtracted(piece, cutter, BrushBoolean.CutLook.OF_SOLID, ids)));
                }
                left = next;
            }
        }
        return left;
    }

    private static void merge(ActionCall call) throws ActionFailure {
        Document document = call.session().document();
        List<Solid> gone = solids(call.session());
        Solid merged = done(BrushBoolean.merged(gone));
        document.edit(MERGE, null, before -> with(document, before, gone, List.of(merged)));
        if (!BrushBoolean.isUnionConvex(gone)) {
            call.session().status(NOTCH);
        }
    }
}
