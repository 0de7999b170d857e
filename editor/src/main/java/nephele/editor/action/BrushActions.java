package nephele.editor.action;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.action.EditorAction.Subject;
import nephele.editor.brush.BrushBoolean;
import nephele.editor.brush.BrushCheck;
import nephele.editor.brush.BrushEdit;
import nephele.editor.brush.BrushShapes;
import nephele.editor.brush.BrushStyle;
import nephele.editor.brush.BrushText;
import nephele.editor.brush.ShapeOptions;
import nephele.editor.document.Document;
import nephele.editor.document.EntityBounds;
import nephele.editor.document.NoteEdits;
import nephele.editor.document.Picker;
import nephele.editor.document.Selection;
import nephele.editor.document.Snapshot;
import nephele.editor.paint.MaterialLibrary;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
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
    private static final Words NOT_FREE = Words.of(
            "too few of the selected solids are neither locked nor hidden: unlock and show them first",
            "há poucos sólidos selecionados que não estão bloqueados nem ocultos: desbloqueie e mostre-os antes",
            "há poucos sólidos selecionados que não estão bloqueados nem ocultos: desbloqueia-os e mostra-os primeiro");
    private static final Words NOTHING_CUT = Words.of(
            "there is nothing to cut: what is selected reaches into no solid",
            "não há o que cortar: o selecionado não entra em nenhum sólido",
            "não há o que cortar: o selecionado não entra em nenhum sólido");
    private static final Words LEFT_ALONE = Words.of(
            "Locked and hidden solids were left alone",
            "Sólidos bloqueados e ocultos ficaram como estavam",
            "Os sólidos bloqueados e ocultos ficaram como estavam");
    private static final Words NO_SHAPE = Words.of(
            "there is no shape '%s': box, wedge, stairs, arch, cylinder, room",
            "não há a forma '%s': box, wedge, stairs, arch, cylinder, room",
            "não há a forma '%s': box, wedge, stairs, arch, cylinder, room");

    static final List<EditorAction> ALL = List.of(
            EditorAction.of("brush", DRAW, Menu.BRUSH, List.of(), BrushActions::draw)
                    .taking("shape", "min", "max", "id", "wall", "steps", "material")
                    .changing(Subject.LEVEL),
            EditorAction.of("hollow", HOLLOW, Menu.BRUSH, List.of("Ctrl+Alt+H"), BrushActions::hollow)
                    .taking("wall")
                    .changing(Subject.LEVEL)
                    .when(BrushActions::hasSolids),
            EditorAction.of("subtract", SUBTRACT, Menu.BRUSH, List.of("Ctrl+Minus"), BrushActions::subtract)
                    .changing(Subject.LEVEL)
                    .when(BrushActions::hasSolids),
            EditorAction.of("merge", MERGE, Menu.BRUSH, List.of("Ctrl+M"), BrushActions::merge)
                    .changing(Subject.LEVEL)
                    .when(BrushActions::hasSolids));

    private BrushActions() {}

    private static boolean hasSolids(EditorSession session) {
        return session.document().selection().entities().stream()
                .anyMatch(ref -> ref.section().equals(Picker.SOLIDS));
    }

    /** Returns the selected solids that are neither locked nor hidden. */
    private static List<Solid> solids(EditorSession session) {
        List<Solid> solids = new ArrayList<>();
        Level level = session.document().level();
        for (EntityRef ref :
                NoteEdits.free(level, session.document().selection().entities())) {
            Entities.LEVEL
                    .find(session.document().level(), ref)
                    .filter(Solid.class::isInstance)
                    .ifPresent(entity -> solids.add((Solid) entity));
        }
        return solids;
    }

    /** Returns the selected solids that may be cut, at least one. */
    private static List<Solid> freeSolids(ActionCall call) throws EditorRefusal {
        List<Solid> solids = solids(call.session());
        if (solids.isEmpty()) {
            throw new EditorRefusal(NOT_FREE);
        }
        return solids;
    }

    /** Returns ids that neither the level nor an earlier call has used. */
    private static Supplier<String> freshIds(Document document, String wish) {
        Set<String> taken = new HashSet<>();
        return () -> {
            String id = Entities.LEVEL.freshId(document.level(), Picker.SOLIDS, wish, taken);
            taken.add(id);
            return id;
        };
    }

    private static void draw(ActionCall call) throws EditorRefusal {
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
                ? BrushShapes.named(drawn, box, side -> freshIds(document, wish + "-" + side)
                        .get())
                : drawn;
        document.edit(DRAW, null, before -> {
            Level with = MaterialLibrary.STANDARD.including(before.level(), material);
            List<Solid> all = new ArrayList<>(with.solids());
            all.addAll(made);
            return new Snapshot(
                    with.with(with.materials(), List.copyOf(all)),
                    Selection.of(made.stream().map(BrushActions::ref).toList()));
        });
    }

    private static ShapeOptions shape(ActionCall call) throws EditorRefusal {
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
            default -> throw new EditorRefusal(NO_SHAPE.with(typed));
        };
    }

    static <T> T done(BrushEdit<T> edit) throws EditorRefusal {
        Optional<BrushText> refusal = edit.refusal();
        if (refusal.isPresent()) {
            throw new EditorRefusal(refusal.get().words());
        }
        return edit.result().orElseThrow();
    }

    /** Makes a step that replaces solids by their pieces, which are then selected. */
    private static void replace(ActionCall call, Words label, Map<Solid, List<Solid>> pieces) {
        Map<EntityRef, List<Record>> records = new LinkedHashMap<>();
        List<EntityRef> made = new ArrayList<>();
        pieces.forEach((solid, parts) -> {
            records.put(ref(solid), parts.stream().map(Record.class::cast).toList());
            parts.forEach(part -> made.add(ref(part)));
        });
        call.session().document().edit(label, null, before -> before.replaced(records)
                .with(Selection.of(made)));
    }

    private static EntityRef ref(Solid solid) {
        return new EntityRef(Picker.SOLIDS, solid.id());
    }

    private static void hollow(ActionCall call) throws EditorRefusal {
        Document document = call.session().document();
        double wall = call.number(
                "wall",
                BrushCheck.LEAST_THICKNESS_METRES,
                ActionCall.MOST,
                call.session().grid().stepMetres());
        Map<Solid, List<Solid>> walls = new LinkedHashMap<>();
        for (Solid solid : freeSolids(call)) {
            walls.put(solid, done(BrushBoolean.hollowed(solid, wall, freshIds(document, solid.id()))));
        }
        replace(call, HOLLOW, walls);
    }

    /** Subtracts what is selected from every free solid that it reaches into, and removes it. */
    private static void subtract(ActionCall call) throws EditorRefusal {
        Document document = call.session().document();
        List<Solid> cutters = freeSolids(call);
        Map<Solid, List<Solid>> pieces = new LinkedHashMap<>();
        Supplier<String> ids = freshIds(document, "cut");
        List<EntityRef> all =
                document.level().solids().stream().map(BrushActions::ref).toList();
        Set<EntityRef> free = Set.copyOf(NoteEdits.free(document.level(), all));
        boolean isAnyLeftAlone = false;
        for (Solid solid : document.level().solids()) {
            List<Solid> left = cutters.contains(solid) ? List.of(solid) : remaining(solid, cutters, ids);
            boolean isCut = !left.equals(List.of(solid));
            if (isCut && free.contains(ref(solid))) {
                pieces.put(solid, left);
            }
            isAnyLeftAlone |= isCut && !free.contains(ref(solid));
        }
        if (pieces.isEmpty() && !isAnyLeftAlone) {
            throw new EditorRefusal(NOTHING_CUT);
        }
        if (isAnyLeftAlone) {
            call.session().status(LEFT_ALONE);
        }
        cutters.forEach(cutter -> pieces.put(cutter, List.of()));
        replace(call, SUBTRACT, pieces);
    }

    private static List<Solid> remaining(Solid solid, List<Solid> cutters, Supplier<String> ids) throws EditorRefusal {
        List<Solid> left = List.of(solid);
        for (Solid cutter : cutters) {
            if (EntityBounds.of((Record) cutter).overlaps(EntityBounds.of((Record) solid))) {
                List<Solid> next = new ArrayList<>();
                for (Solid piece : left) {
                    next.addAll(done(BrushBoolean.subtracted(piece, cutter, ids)));
                }
                left = next;
            }
        }
        return left;
    }

    private static void merge(ActionCall call) throws EditorRefusal {
        List<Solid> gone = solids(call.session());
        if (gone.size() < 2) {
            throw new EditorRefusal(NOT_FREE);
        }
        Solid merged = done(BrushBoolean.merged(gone));
        Map<Solid, List<Solid>> pieces = new LinkedHashMap<>();
        gone.forEach(solid -> pieces.put(solid, pieces.isEmpty() ? List.of(merged) : List.of()));
        replace(call, MERGE, pieces);
        if (!BrushBoolean.isUnionConvex(gone)) {
            call.session().status(NOTCH);
        }
    }
}
