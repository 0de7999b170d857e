package nephele.editor.tool.transform;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import nephele.editor.document.EntityBounds;
import nephele.editor.document.EntityTransform;
import nephele.editor.document.NoteEdits;
import nephele.editor.document.Snapshot;
import nephele.editor.pane.Mark;
import nephele.editor.record.Entities;
import nephele.editor.text.Words;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Pointer.Modifier;
import nephele.editor.tool.Snap;
import nephele.editor.tool.SnappedMove;
import nephele.editor.tool.Tool;
import nephele.editor.tool.ToolContext;
import nephele.editor.tool.ToolEntry;
import nephele.editor.tool.WorldAxis;
import nephele.editor.tool.select.SelectTool;
import nephele.editor.tool.transform.Gizmo.Grip;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

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
            context -> new TransformTool(context, Gizmo.MOVE));

    public static final ToolEntry ROTATE = new ToolEntry(
            "rotate",
            Words.of("Rotate", "Girar", "Rodar"),
            Words.of(
                    "Drag a ring to turn by 15°; Shift: by 5°",
                    "Arraste um anel para girar de 15° em 15°; Shift: de 5° em 5°",
                    "Arrasta um anel para rodar de 15° em 15°; Shift: de 5° em 5°"),
            "E",
            context -> new TransformTool(context, Gizmo.ROTATE));

    public static final ToolEntry SCALE = new ToolEntry(
            "scale",
            Words.of("Scale", "Escalar", "Dimensionar"),
            Words.of(
                    "Drag a handle of a side to stretch, of a corner to scale all sides",
                    "Arraste a alça de um lado para esticar, a de um canto para escalar todos os lados",
                    "Arrasta a pega de um lado para esticar, a de um canto para dimensionar todos os lados"),
            "R",
            context -> new TransformTool(context, Gizmo.SCALE));

    private static final double TURN_DEGREES = 15;
    private static final double FINE_TURN_DEGREES = 5;

    private final ToolContext context;
    private final Gizmo gizmo;
    private final Tool select;
    /** The last pointer event; the gizmo has the size of its pane. */
    private Pointer last;

    private String hovered = "";
    /** The grip that a drag holds; {@code null} without one. */
    private Grip taken;

    private Pointer start;

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
            taken = grip.get();
            start = pointer;
        } else {
            select.pressed(pointer);
        }
    }

    private Optional<Grip> under(Pointer pointer) {
        return grips(pointer).stream()
                .filter(grip -> grip.pixelsFrom(pointer) < Pointer.REACH_PIXELS)
                .min(Comparator.comparingDouble(grip -> grip.pixelsFrom(pointer)));
    }

    private List<Grip> grips(Pointer pointer) {
        Aabb bounds = bounds();
        if (bounds.isEmpty()) {
            return List.of();
        }
        double metresPerPixel = pointer.camera().metresPerPixel(bounds.centre(), pointer.size());
        List<Grip> grips = new ArrayList<>(gizmo.grips(bounds, metresPerPixel));
        grips.removeIf(
                grip -> pointer.isPlan() && !grip.isUsable(pointer.camera().forward()));
        return grips;
    }

    private Aabb bounds() {
        Snapshot now = context.document().now();
        return EntityBounds.of(
                now.level(), NoteEdits.unlocked(now.level(), now.selection().entities()));
    }

    @Override
    public void dragged(Pointer pointer) {
        last = pointer;
        if (taken == null) {
            select.dragged(pointer);
            return;
        }
        change(pointer).ifPresent(change -> context.document()
                .drag(before -> before.with(Entities.LEVEL.changed(
                        before.level(),
                        NoteEdits.unlocked(before.level(), before.selection().entities()),
                        change))));
    }

    @Override
    public void released(Pointer pointer) {
        if (taken == null) {
            select.released(pointer);
        } else {
            context.document().commitDrag(entry().title());
            taken = null;
        }
    }

    @Override
    public void cancel() {
        select.cancel();
        context.document().cancelDrag();
        taken = null;
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

    /** Returns the change of each entity by the taken grip; empty where the pointer has no meaning, as over the horizon. */
    private Optional<UnaryOperator<Record>> change(Pointer now) {
        return switch (taken.change()) {
            case MOVE_ALONG -> along(now).map(metres -> moved(taken.direction().scaled(metres)));
            case MOVE_IN_PLANE -> inPlane(now).map(TransformTool::moved);
            case TURN -> degrees(now).map(this::turned);
            case SCALE_AXIS -> factor(now).map(this::scaledAlong);
            case SCALE_ALL -> factor(now).map(f -> scaled(new Vec3(f, f, f)));
        };
    }

    private SnappedMove move() {
        return new SnappedMove(context, taken.origin());
    }

    private Optional<Double> along(Pointer now) {
        return between(now).map(metres -> move().length(now, taken.direction(), metres));
    }

    /** Returns the movement along the direction, in lengths of it. */
    private Optional<Double> between(Pointer now) {
        Optional<Double> from = start.alongLine(taken.origin(), taken.direction());
        return from.flatMap(
                begin -> now.alongLine(taken.origin(), taken.direction()).map(end -> end - begin));
    }

    private Optional<Vec3> inPlane(Pointer now) {
        Vec3 normal = taken.direction();
        WorldAxis axis = WorldAxis.nearest(normal);
        return start.onPlane(taken.origin(), normal).flatMap(from -> now.onPlane(taken.origin(), normal)
                .map(to -> axis.with(move().offset(now, to.minus(from)), 0)));
    }

    private Optional<Double> degrees(Pointer now) {
        Vec3 axis = taken.direction();
        double step = now.isHeld(Modifier.SHIFT) ? FINE_TURN_DEGREES : TURN_DEGREES;
        return start.onPlane(taken.origin(), axis)
                .flatMap(from -> now.onPlane(taken.origin(), axis).map(to -> step * Math.rint(angle(from, to) / step)));
    }

    private double angle(Vec3 from, Vec3 to) {
        Vec3 a = from.minus(taken.origin());
        Vec3 b = to.minus(taken.origin());
        return Math.toDegrees(Math.atan2(a.cross(b).dot(taken.direction()), a.dot(b)));
    }

    /** Returns how many times as long the longest side becomes: it snaps, and stays at least a step. */
    private Optional<Double> factor(Pointer now) {
        Vec3 sides = taken.direction();
        double size = Math.abs(WorldAxis.nearest(sides).of(sides));
        double least = Math.min(context.grid().stepMetres(), size);
        return between(now).map(by -> by == 0 ? 1 : Math.max(least, Snap.length(context, size * (1 + by))) / size);
    }

    private UnaryOperator<Record> scaledAlong(double factor) {
        WorldAxis axis = WorldAxis.nearest(taken.direction());
        return scaled(axis.with(new Vec3(1, 1, 1), factor));
    }

    private UnaryOperator<Record> scaled(Vec3 factors) {
        return factors.equals(new Vec3(1, 1, 1))
                ? UnaryOperator.identity()
                : entity -> EntityTransform.scaled(entity, taken.origin(), factors);
    }

    private UnaryOperator<Record> turned(double degrees) {
        return degrees == 0
                ? UnaryOperator.identity()
                : entity -> EntityTransform.turned(entity, taken.origin(), taken.direction(), degrees);
    }

    private static UnaryOperator<Record> moved(Vec3 by) {
        return by.equals(Vec3.ZERO) ? UnaryOperator.identity() : entity -> EntityTransform.moved(entity, by);
    }

    private ToolEntry entry() {
        return switch (gizmo) {
            case MOVE -> MOVE;
            case ROTATE -> ROTATE;
            case SCALE -> SCALE;
        };
    }
}
