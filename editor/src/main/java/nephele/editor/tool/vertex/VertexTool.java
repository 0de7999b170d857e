package nephele.editor.tool.vertex;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import nephele.editor.brush.BrushEdit;
import nephele.editor.brush.VertexEdit;
import nephele.editor.document.NoteEdits;
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
import nephele.editor.tool.select.SelectTool;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;

/**
 * Moves vertices and edges of the selected brushes, which stay convex. Vertices of several brushes at one place move
 * together; Alt moves vertically, Control splits an edge in its middle. Elsewhere the pointer selects as with the select tool.
 */
public final class VertexTool implements Tool {
    public static final ToolEntry ENTRY = new ToolEntry(
            "vertex",
            Words.of("Vertex", "Vértice", "Vértice"),
            Words.of(
                    "Drag vertices or middles of edges; Shift: several, Alt: vertically, Ctrl: split the edge",
                    "Arraste vértices ou meios de arestas; Shift: vários, Alt: na vertical, Ctrl: divide a aresta",
                    "Arrasta vértices ou meios de arestas; Shift: vários, Alt: na vertical, Ctrl: divide a aresta"),
            "V",
            VertexTool::new);

    private static final Words MOVE = Words.of("Move vertices", "Mover vértices", "Mover vértices");

    private final ToolContext context;
    private final Tool select;
    private final Set<VertexGrip> selected = new LinkedHashSet<>();
    private VertexGrip hovered;
    /** The grip under the pointer when it was pressed; {@code null} without a drag of it. */
    private VertexGrip taken;

    private Pointer start;
    /** The displacement by the drag in progress, metres. */
    private Vec3 by = Vec3.ZERO;

    public VertexTool(ToolContext context) {
        this.context = context;
        select = new SelectTool(context);
    }

    @Override
    public void moved(Pointer pointer) {
        hovered = under(pointer).orElse(null);
    }

    private Optional<VertexGrip> under(Pointer pointer) {
        return grips().stream()
                .filter(grip -> pointer.reaches(grip.at()))
                .min(Comparator.comparingDouble(grip -> depthMetres(grip, pointer)));
    }

    private static double depthMetres(VertexGrip grip, Pointer pointer) {
        return pointer.camera().project(grip.at(), pointer.size()).orElseThrow().depthMetres();
    }

    private List<VertexGrip> grips() {
        Snapshot now = context.document().now();
        List<VertexGrip> grips = new ArrayList<>();
        for (EntityRef ref : NoteEdits.free(now.level(), now.selection().entities())) {
            Solid solid = solid(now.level(), ref);
            if (solid != null && context.shapes().brush(solid).isPresent()) {
                VertexEdit.vertices(solid).forEach(vertex -> grips.add(new VertexGrip(ref, List.of(vertex))));
                VertexEdit.edges(solid)
                        .forEach(edge -> grips.add(new VertexGrip(ref, List.of(edge.from(), edge.to()))));
            }
        }
        return grips;
    }

    /** Returns {@code null} for an entity of another kind. */
    private Solid solid(Level level, EntityRef ref) {
        return Entities.LEVEL.find(level, ref).orElse(null) instanceof Solid solid ? solid : null;
    }

    @Override
    public void left() {
        hovered = null;
    }

    @Override
    public void pressed(Pointer pointer) {
        taken = under(pointer).orElse(null);
        start = pointer;
        by = Vec3.ZERO;
        if (taken == null) {
            selected.clear();
            select.pressed(pointer);
            return;
        }
        List<VertexGrip> all = grips();
        selected.retainAll(all);
        List<VertexGrip> here =
                all.stream().filter(grip -> grip.isBeside(taken)).toList();
        if (pointer.isHeld(Modifier.SHIFT) && selected.containsAll(here)) {
            here.forEach(selected::remove);
            taken = null;
        } else {
            if (!pointer.isHeld(Modifier.SHIFT) && !selected.contains(taken)) {
                selected.clear();
            }
            selected.addAll(here);
        }
    }

    @Override
    public void dragged(Pointer pointer) {
        if (taken == null) {
            if (selected.isEmpty()) {
                select.dragged(pointer);
            }
            return;
        }
        offset(pointer).ifPresent(this::show);
    }

    private Optional<Vec3> offset(Pointer pointer) {
        Vec3 at = taken.at();
        if (pointer.isHeld(Modifier.ALT) && !pointer.isPlan()) {
            Vec3 up = new Vec3(0, 1, 0);
            return pointer.alongLine(at, up).map(metres -> up.scaled(Snap.length(context, metres)));
        }
        return pointer.onPlane(at, start.dragPlaneNormal()).map(to -> Snap.offset(context, to.minus(at)));
    }

    private void show(Vec3 offset) {
        by = Vec3.ZERO;
        if (offset.equals(Vec3.ZERO)) {
            context.document().cancelDrag();
            return;
        }
        context.document().drag(before -> {
            BrushEdit<Level> edit = splits() ? split(before.level(), offset) : moved(before.level(), offset);
            context.status(edit.refusal().map(why -> why.words()).orElse(Words.NONE));
            edit.result().ifPresent(done -> by = offset);
            return edit.result().map(before::with).orElse(before);
        });
    }

    private boolean splits() {
        return start.isHeld(Modifier.CONTROL) && !taken.isVertex();
    }

    private BrushEdit<Level> split(Level level, Vec3 offset) {
        Solid solid = solid(level, taken.solid());
        return changed(
                level, taken.solid(), VertexEdit.withVertex(solid, taken.at().plus(offset)));
    }

    private BrushEdit<Level> moved(Level before, Vec3 offset) {
        BrushEdit<Level> edit = BrushEdit.done(before);
        for (Map.Entry<EntityRef, Set<Vec3>> moved : vertices().entrySet()) {
            EntityRef ref = moved.getKey();
            edit = edit.flatMap(
                    level -> changed(level, ref, VertexEdit.moved(solid(level, ref), moved.getValue(), offset)));
        }
        return edit;
    }

    /** Returns the vertices that move, by their solids. */
    private Map<EntityRef, Set<Vec3>> vertices() {
        Map<EntityRef, Set<Vec3>> moving = new LinkedHashMap<>();
        for (VertexGrip grip : selected) {
            moving.computeIfAbsent(grip.solid(), ref -> new LinkedHashSet<>()).addAll(grip.vertices());
        }
        return moving;
    }

    private BrushEdit<Level> changed(Level level, EntityRef ref, BrushEdit<Solid> edit) {
        return edit.map(solid -> Entities.LEVEL.changed(level, List.of(ref), entity -> (Record) solid));
    }

    @Override
    public void released(Pointer pointer) {
        if (taken == null) {
            select.released(pointer);
            return;
        }
        context.document().commitDrag(MOVE);
        List<VertexGrip> moved = grips().stream().filter(this::isSelected).toList();
        selected.clear();
        selected.addAll(moved);
        by = Vec3.ZERO;
        taken = null;
        hovered = null;
    }

    @Override
    public void cancel() {
        select.cancel();
        context.document().cancelDrag();
        taken = null;
        by = Vec3.ZERO;
    }

    @Override
    public List<Mark> marks() {
        List<Mark> marks = new ArrayList<>(select.marks());
        for (VertexGrip grip : grips()) {
            marks.add(new Mark.Handle(grip.at(), colour(grip)));
        }
        return marks;
    }

    /** Returns true for a grip that was selected before the drag moved it. */
    private boolean isSelected(VertexGrip grip) {
        return selected.stream().anyMatch(before -> before.isAt(grip, by));
    }

    private MarkColour colour(VertexGrip grip) {
        if (grip.equals(hovered)) {
            return MarkColour.HOVERED;
        } else if (isSelected(grip)) {
            return MarkColour.SELECTED;
        }
        return grip.isVertex() ? MarkColour.EDGE : MarkColour.GUIDE;
    }

    @Override
    public Words hint() {
        return ENTRY.description();
    }

    /**
     * A vertex of a solid, or an edge by its middle.
     *
     * @param vertices the vertex, or both ends of the edge
     */
    private record VertexGrip(EntityRef solid, List<Vec3> vertices) {
        private static final double SAME_METRES = 1e-6;

        Vec3 at() {
            return vertices.get(0).lerp(vertices.get(vertices.size() - 1), 0.5);
        }

        boolean isVertex() {
            return vertices.size() == 1;
        }

        /** Returns true if another grip of the solid is where this one is after a movement, but for rounding. */
        boolean isAt(VertexGrip other, Vec3 by) {
            boolean isSame = solid.equals(other.solid) && vertices.size() == other.vertices.size();
            for (int i = 0; isSame && i < vertices.size(); i++) {
                isSame = isIn(vertices.get(i).plus(by), other.vertices);
            }
            return isSame;
        }

        /** Returns true for a grip of any solid at the same place, but for rounding. */
        boolean isBeside(VertexGrip other) {
            return at().minus(other.at()).length() < SAME_METRES;
        }

        private static boolean isIn(Vec3 vertex, List<Vec3> others) {
            return others.stream().anyMatch(other -> other.minus(vertex).length() < SAME_METRES);
        }
    }
}
