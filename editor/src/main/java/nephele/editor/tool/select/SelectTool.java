package nephele.editor.tool.select;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import nephele.editor.document.EntityBounds;
import nephele.editor.document.EntityTransform;
import nephele.editor.document.NoteEdits;
import nephele.editor.document.Picker;
import nephele.editor.document.Selection;
import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.editor.record.EntityRef;
import nephele.editor.text.Words;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Pointer.Modifier;
import nephele.editor.tool.SnappedMove;
import nephele.editor.tool.Tool;
import nephele.editor.tool.ToolContext;
import nephele.editor.tool.ToolEntry;
import nephele.engine.level.EditorNotes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * Selects by clicks and rectangles, and moves what is selected. A click at the same place again takes the next entity
 * behind it; Shift adds; Alt takes only what is wholly inside the rectangle, or moves vertically.
 */
public final class SelectTool implements Tool {
    public static final ToolEntry ENTRY = new ToolEntry(
            "select",
            Words.of("Select", "Selecionar", "Selecionar"),
            Words.of(
                    "Click to select, drag to move; drag from an empty place for a rectangle",
                    "Clique para selecionar, arraste para mover; arraste de um lugar vazio para um retângulo",
                    "Clica para selecionar, arrasta para mover; arrasta de um sítio vazio para um retângulo"),
            "Q",
            SelectTool::new);

    private static final Words MOVE = Words.of("Move", "Mover", "Mover");
    /** Movement below which a press and release are a click, in pixels. */
    private static final double CLICK_PIXELS = 4;

    /** The ground is everywhere below the pointer: only the handles of the move tool drag it. */
    private static final String TERRAINS = "terrains";

    private static final Set<String> BACKDROPS = Set.of(TERRAINS, "environment.clouds");

    private final ToolContext context;
    private Pointer start;
    private Pointer now;
    /** The place under the pointer when it was pressed on a selected entity; {@code null} if the drag selects. */
    private Vec3 grabbed;

    private boolean isDragging;
    private Pointer lastClick;
    private int drilled;

    public SelectTool(ToolContext context) {
        this.context = context;
    }

    @Override
    public void pressed(Pointer pointer) {
        start = pointer;
        now = pointer;
        isDragging = false;
        grabbed = null;
        for (Picker.Pick pick : context.picker().along(pointer.ray())) {
            boolean isGround = pick.entity().section().equals(TERRAINS);
            if (!isGround && context.document().selection().contains(pick.entity())) {
                grabbed = pick.point();
                return;
            }
        }
    }

    @Override
    public void dragged(Pointer pointer) {
        if (start == null) {
            return;
        }
        now = pointer;
        isDragging |= Math.hypot(pointer.x() - start.x(), pointer.y() - start.y()) > CLICK_PIXELS;
        if (isDragging && grabbed != null) {
            move(pointer);
        }
    }

    private void move(Pointer pointer) {
        Optional<Vec3> by = pointer.isHeld(Modifier.ALT) && !pointer.isPlan() ? vertical(pointer) : inPlane(pointer);
        by.ifPresent(offset -> {
            Vec3 snapped = new SnappedMove(context, grabbed).offset(pointer, offset);
            context.document()
                    .drag(before -> before.with(EntityTransform.moved(
                            before.level(),
                            NoteEdits.unlocked(
                                    before.level(), before.selection().entities()),
                            snapped,
                            context.options().isTextureLocked())));
        });
    }

    private Optional<Vec3> inPlane(Pointer pointer) {
        return pointer.onPlane(grabbed, start.dragPlaneNormal()).map(at -> at.minus(grabbed));
    }

    private Optional<Vec3> vertical(Pointer pointer) {
        Vec3 up = new Vec3(0, 1, 0);
        return pointer.alongLine(grabbed, up).map(up::scaled);
    }

    @Override
    public void released(Pointer pointer) {
        if (start == null) {
            return;
        }
        if (!isDragging) {
            click(pointer);
        } else if (grabbed != null) {
            context.document().commitDrag(MOVE);
        } else {
            selectRectangle(pointer);
        }
        start = null;
    }

    private void click(Pointer pointer) {
        List<EntityRef> hit = context.picker().along(pointer.ray()).stream()
                .map(Picker.Pick::entity)
                .distinct()
                .toList();
        boolean isAgain = lastClick != null
                && lastClick.camera().equals(pointer.camera())
                && Math.hypot(pointer.x() - lastClick.x(), pointer.y() - lastClick.y()) < CLICK_PIXELS;
        drilled = isAgain && !hit.isEmpty() ? (drilled + 1) % hit.size() : 0;
        lastClick = pointer;
        List<EntityRef> taken = hit.isEmpty() ? List.of() : grouped(List.of(hit.get(drilled)));
        apply(taken, pointer);
    }

    private void apply(List<EntityRef> taken, Pointer pointer) {
        Selection before = context.document().selection();
        boolean adds = pointer.isHeld(Modifier.SHIFT) || pointer.isHeld(Modifier.CONTROL);
        context.document().select(adds ? before.toggled(taken) : Selection.of(taken));
    }

    /** Returns the entities with all members of their groups. */
    private List<EntityRef> grouped(List<EntityRef> refs) {
        Set<EntityRef> all = new LinkedHashSet<>(refs);
        for (EditorNotes.Group group : context.document().level().editor().groups()) {
            List<EntityRef> members =
                    group.members().stream().map(EntityRef::of).toList();
            if (members.stream().anyMatch(refs::contains)) {
                all.addAll(members);
            }
        }
        return List.copyOf(all);
    }

    private void selectRectangle(Pointer pointer) {
        Picker picker = context.picker();
        boolean onlyInside = pointer.isHeld(Modifier.ALT);
        List<EntityRef> found = new ArrayList<>(
                !pointer.isPlan()
                        ? inView(pointer)
                        : onlyInside ? picker.inside(region(pointer)) : picker.touching(region(pointer)));
        // Ground and clouds are behind everything: a rectangle means them only if it is around them.
        List<EntityRef> inside = pointer.isPlan() ? picker.inside(region(pointer)) : List.of();
        found.removeIf(ref -> BACKDROPS.contains(ref.section()) && !inside.contains(ref));
        apply(grouped(found), pointer);
    }

    /** Returns the rectangle of a plan, as deep as the world. */
    private Aabb region(Pointer pointer) {
        Vec3 a = at(start);
        Vec3 b = at(pointer);
        Vec3 along = pointer.camera().forward();
        Vec3 far = new Vec3(Math.abs(along.x()), Math.abs(along.y()), Math.abs(along.z())).scaled(1e8);
        Aabb box = Aabb.of(List.of(a, b));
        return Aabb.of(List.of(
                new Vec3(box.minX(), box.minY(), box.minZ()).minus(far),
                new Vec3(box.maxX(), box.maxY(), box.maxZ()).plus(far)));
    }

    /** Returns what appears in the rectangle of a perspective view, by the middle of its bounds. */
    private List<EntityRef> inView(Pointer pointer) {
        Aabb everywhere = new Aabb(-1e8, -1e8, -1e8, 1e8, 1e8, 1e8);
        List<EntityRef> found = new ArrayList<>(context.picker().touching(everywhere));
        found.removeIf(ref -> !appears(ref, pointer));
        return found;
    }

    private boolean appears(EntityRef ref, Pointer pointer) {
        Aabb box = EntityBounds.of(context.document().level(), ref);
        return pointer.camera()
                .project(box.centre(), pointer.size())
                .filter(p -> p.x() >= Math.min(start.x(), pointer.x())
                        && p.x() <= Math.max(start.x(), pointer.x())
                        && p.y() >= Math.min(start.y(), pointer.y())
                        && p.y() <= Math.max(start.y(), pointer.y()))
                .isPresent();
    }

    /** Returns the place of the pointer in the plane through the middle of the picture, or near the eye. */
    private static Vec3 at(Pointer pointer) {
        return pointer.ray().at(pointer.isPlan() ? 2e7 : 1);
    }

    @Override
    public void cancel() {
        context.document().cancelDrag();
        start = null;
        isDragging = false;
    }

    @Override
    public List<Mark> marks() {
        if (start == null || !isDragging || grabbed != null) {
            return List.of();
        }
        return rectangle(start, now);
    }

    @Override
    public Words hint() {
        return ENTRY.description();
    }

    /** Returns the rectangle between two places of the pointer, as lines just before the camera. */
    private static List<Mark> rectangle(Pointer a, Pointer b) {
        Vec3 first = at(b, a.x(), a.y());
        Vec3 second = at(b, b.x(), a.y());
        Vec3 third = at(b, b.x(), b.y());
        Vec3 fourth = at(b, a.x(), b.y());
        return List.of(line(first, second), line(second, third), line(third, fourth), line(fourth, first));
    }

    private static Vec3 at(Pointer pointer, double x, double y) {
        return pointer.camera().ray(x, y, pointer.size()).at(pointer.isPlan() ? 2e7 : 1);
    }

    private static Mark line(Vec3 from, Vec3 to) {
        return new Mark.Line(from, to, MarkColour.PREVIEW, Mark.Visibility.ALWAYS);
    }
}
