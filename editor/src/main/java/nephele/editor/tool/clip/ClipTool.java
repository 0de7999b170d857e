package nephele.editor.tool.clip;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import nephele.editor.brush.BrushClip;
import nephele.editor.brush.BrushClip.Keep;
import nephele.editor.brush.BrushEdit;
import nephele.editor.brush.BrushText;
import nephele.editor.brush.VertexEdit;
import nephele.editor.document.NoteEdits;
import nephele.editor.document.Picker;
import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.text.Words;
import nephele.editor.tool.FacesUnderPointer;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Pointer.Modifier;
import nephele.editor.tool.Snap;
import nephele.editor.tool.Tool;
import nephele.editor.tool.ToolContext;
import nephele.editor.tool.ToolEntry;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.math.Aabb;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/**
 * Cuts the selected brushes, or without any those at the points, by the plane through two points of a plan or three of
 * the perspective view. Nothing changes before Enter.
 */
public final class ClipTool implements Tool {
    public static final ToolEntry ENTRY = new ToolEntry(
            "clip",
            Words.of("Clip", "Cortar", "Cortar"),
            Words.of(
                    "Set 2 points in a plan, 3 in 3-D; double click: face; Enter: cut",
                    "2 pontos numa planta, 3 em 3-D; duplo clique: face; Enter: cortar",
                    "2 pontos numa planta, 3 em 3-D; duplo clique: face; Enter: cortar"),
            "C",
            ClipTool::new);

    private static final Words CLIP = Words.of("Clip", "Cortar", "Cortar");
    private static final Words KEEPS_BEHIND =
            Words.of("keeps what is behind", "fica o que está atrás", "fica o que está atrás");
    private static final Words KEEPS_FRONT =
            Words.of("keeps what is in front", "fica o que está à frente", "fica o que está à frente");
    private static final Words KEEPS_BOTH =
            Words.of("keeps both parts", "ficam as duas partes", "ficam as duas partes");

    private static final double FAR_METRES = 1e8;
    private static final double NEAR_METRES = 1e-3;

    private final ToolContext context;
    /** The points that give the plane: two and the direction of sight of a plan, or three. */
    private List<Vec3> points = new ArrayList<>();

    /** The direction of sight of the plan with the points; {@code null} for points in the perspective view. */
    private Vec3 sight;

    private Keep keep = Keep.BEHIND;
    /** Index of the point that the pointer moves; -1 without one. */
    private int moving = -1;

    public ClipTool(ToolContext context) {
        this.context = context;
    }

    /** Takes the next of the choices what stays: the part behind the plane, that in front, both. */
    public void cycle() {
        keep = Keep.values()[(keep.ordinal() + 1) % Keep.values().length];
    }

    /** Returns what stays after the cut. */
    public Keep keep() {
        return keep;
    }

    /** Chooses what stays after the cut. */
    public void keep(Keep choice) {
        keep = choice;
    }

    @Override
    public void pressed(Pointer pointer) {
        moving = -1;
        if (pointer.isHeld(Modifier.CONTROL)) {
            cycle();
            return;
        }
        if (pointer.clicks() == 2 && !pointer.isPlan()) {
            useFace(pointer);
            return;
        }
        Vec3 paneSight = pointer.isPlan() ? pointer.camera().forward() : null;
        boolean isSamePane = Objects.equals(paneSight, sight);
        for (int i = 0; isSamePane && i < points.size(); i++) {
            if (pointer.reaches(points.get(i))) {
                moving = i;
                return;
            }
        }
        boolean isNew = !isSamePane || isComplete();
        place(pointer).ifPresent(at -> {
            if (isNew) {
                points.clear();
                sight = paneSight;
            }
            points.add(at);
            moving = points.size() - 1;
        });
    }

    private boolean isComplete() {
        return points.size() == (sight == null ? 3 : 2);
    }

    /** Takes three corners of the face under the pointer as the points. */
    private void useFace(Pointer pointer) {
        FacesUnderPointer.at(context, pointer)
                .flatMap(face -> FacesUnderPointer.shape(context.document().level(), face))
                .ifPresent(face -> {
                    List<Vec3> corners = face.polygon();
                    int count = corners.size();
                    sight = null;
                    points = new ArrayList<>(
                            List.of(corners.get(0), corners.get(count / 3), corners.get(count * 2 / 3)));
                });
    }

    private Optional<Vec3> place(Pointer pointer) {
        return on(pointer).map(at -> Snap.place(context, pointer, at));
    }

    private Optional<Vec3> on(Pointer pointer) {
        if (pointer.isPlan()) {
            return pointer.onPlane(Vec3.ZERO, pointer.camera().forward());
        }
        List<Picker.Pick> surfaces = context.picker().surfaces(pointer.ray());
        return surfaces.isEmpty()
                ? pointer.onPlane(Vec3.ZERO, new Vec3(0, 1, 0))
                : Optional.of(surfaces.get(0).point());
    }

    @Override
    public void dragged(Pointer pointer) {
        if (moving >= 0) {
            place(pointer).ifPresent(at -> points.set(moving, at));
        }
    }

    @Override
    public void released(Pointer pointer) {
        moving = -1;
    }

    @Override
    public void cancel() {
        points.clear();
        sight = null;
        moving = -1;
    }

    /** Returns the plane through the points; empty while points are missing or lie on a line. */
    private Optional<Plane> plane() {
        if (!isComplete()) {
            return Optional.empty();
        }
        Vec3 along = points.get(1).minus(points.get(0));
        Vec3 normal = along.cross(sight == null ? points.get(2).minus(points.get(0)) : sight);
        if (!(normal.length() > 0)) {
            return Optional.empty();
        }
        return Optional.of(Plane.through(Plane.of(normal, 0).normal(), points.get(0)));
    }

    /** Returns the box around the points, as deep as the world in a plan. */
    private Aabb reach() {
        Aabb box = Aabb.of(points).grown(NEAR_METRES);
        return sight == null
                ? box
                : box.union(box.moved(sight.scaled(FAR_METRES))).union(box.moved(sight.scaled(-FAR_METRES)));
    }

    @Override
    public boolean confirm() {
        Optional<Plane> plane = plane();
        if (plane.isEmpty()) {
            return false;
        }
        Map<EntityRef, List<Solid>> parts = parts(plane.get(), keep);
        if (parts.isEmpty()) {
            context.status(BrushText.PLANE_MISSES.words());
            return true;
        }
        context.document().edit(CLIP, null, before -> before.replaced(records(parts)));
        cancel();
        return true;
    }

    private static Map<EntityRef, List<Record>> records(Map<EntityRef, List<Solid>> parts) {
        Map<EntityRef, List<Record>> records = new LinkedHashMap<>();
        parts.forEach((ref, solids) ->
                records.put(ref, solids.stream().map(Record.class::cast).toList()));
        return records;
    }

    /** Returns what stays of the brushes that the plane cuts. */
    private Map<EntityRef, List<Solid>> parts(Plane plane, Keep kept) {
        Level level = context.document().level();
        Map<EntityRef, List<Solid>> parts = new LinkedHashMap<>();
        Set<String> taken = new HashSet<>();
        for (EntityRef ref : targets()) {
            Solid solid = (Solid) Entities.LEVEL.find(level, ref).orElseThrow();
            String other = Entities.LEVEL.freshId(level, Picker.SOLIDS, ref.id(), taken);
            BrushEdit<List<Solid>> edit = BrushClip.clipped(solid, plane, kept, Solid.Face.INHERITED, other);
            edit.result().ifPresent(solids -> {
                parts.put(ref, solids);
                taken.add(other);
            });
        }
        return parts;
    }

    private List<EntityRef> targets() {
        List<EntityRef> refs = context.document().selection().entities();
        List<EntityRef> from = refs.isEmpty() ? context.picker().touching(reach()) : refs;
        return NoteEdits.free(context.document().level(), from).stream()
                .filter(ref -> ref.section().equals(Picker.SOLIDS))
                .filter(this::hasVolume)
                .toList();
    }

    private boolean hasVolume(EntityRef ref) {
        return context.shapes().brushes().stream()
                .anyMatch(brush -> brush.solidId().equals(ref.id()));
    }

    @Override
    public List<Mark> marks() {
        List<Mark> marks = new ArrayList<>();
        for (int i = 0; i < points.size(); i++) {
            marks.add(new Mark.Handle(points.get(i), MarkColour.GUIDE));
            marks.add(line(points.get(i), points.get((i + 1) % points.size()), MarkColour.GUIDE));
        }
        plane().ifPresent(plane -> parts(plane, Keep.BOTH).values().forEach(both -> {
            addEdges(marks, both.get(0), keep != Keep.IN_FRONT);
            addEdges(marks, both.get(1), keep != Keep.BEHIND);
        }));
        return marks;
    }

    private static void addEdges(List<Mark> marks, Solid part, boolean stays) {
        MarkColour colour = stays ? MarkColour.PREVIEW : MarkColour.REFUSED;
        VertexEdit.edges(part).forEach(edge -> marks.add(line(edge.from(), edge.to(), colour)));
    }

    private static Mark line(Vec3 from, Vec3 to, MarkColour colour) {
        return new Mark.Line(from, to, colour, Mark.Visibility.ALWAYS);
    }

    @Override
    public Words hint() {
        Words kept = keep == Keep.BOTH ? KEEPS_BOTH : keep == Keep.BEHIND ? KEEPS_BEHIND : KEEPS_FRONT;
        return Words.same("%s; %s").with(ENTRY.description(), kept);
    }
}
