package nephele.editor.tool.brush;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import nephele.editor.brush.BrushEdit;
import nephele.editor.brush.BrushShapes;
import nephele.editor.brush.BrushStyle;
import nephele.editor.brush.BrushText;
import nephele.editor.brush.ShapeOptions;
import nephele.editor.document.EntityBounds;
import nephele.editor.document.Picker;
import nephele.editor.document.Selection;
import nephele.editor.document.Snapshot;
import nephele.editor.paint.MaterialLibrary;
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
import nephele.editor.tool.WorldAxis;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * Draws a brush from corner to corner on a surface, or in the plane of a plan. Shift makes its base square; Alt changes
 * the height instead of the base. In a plan the brush is as deep as the last one that was drawn or is selected.
 */
public final class DrawBrushTool implements Tool {
    public static final ToolEntry ENTRY = new ToolEntry(
            "brush",
            Words.of("Brush", "Bloco", "Bloco"),
            Words.of(
                    "Drag to draw a brush; Shift: square base, Alt: height",
                    "Arraste para desenhar um bloco; Shift: base quadrada, Alt: altura",
                    "Arrasta para desenhar um bloco; Shift: base quadrada, Alt: altura"),
            "B",
            DrawBrushTool::new);

    private static final Words DRAW = Words.of("Draw brush", "Desenhar bloco", "Desenhar bloco");
    private static final int HEIGHT_STEPS = 2;
    /** The clear height of a room before Alt changes it. */
    private static final double ROOM_METRES = 4;

    private final ToolContext context;
    /** The box in progress; {@code null} without a drag. */
    private DrawnBox box;
    /** The bounds of the last brush that was drawn; in a plan they give the depth of the next one. */
    private Aabb last = Aabb.EMPTY;

    private Vec3 corner;

    public DrawBrushTool(ToolContext context) {
        this.context = context;
    }

    @Override
    public void moved(Pointer pointer) {
        corner = base(pointer).map(DrawnBox::first).orElse(null);
    }

    @Override
    public void left() {
        corner = null;
    }

    @Override
    public void pressed(Pointer pointer) {
        box = base(pointer).orElse(null);
        corner = null;
    }

    /** Returns the box without extent at the pointer, as high or deep as it will be. */
    private Optional<DrawnBox> base(Pointer pointer) {
        if (pointer.isPlan()) {
            return inPlan(pointer);
        }
        List<Picker.Pick> surfaces = context.picker().surfaces(pointer.ray());
        if (surfaces.isEmpty()) {
            Vec3 up = WorldAxis.Y.unit();
            return pointer.onPlane(Vec3.ZERO, up).map(at -> on(pointer, at, up, -wall()));
        }
        Picker.Pick surface = surfaces.get(0);
        WorldAxis axis = WorldAxis.nearest(surface.normal());
        return Optional.of(on(pointer, surface.point(), surface.normal(), height(surface, axis)));
    }

    private DrawnBox on(Pointer pointer, Vec3 at, Vec3 normal, double baseMetres) {
        WorldAxis axis = WorldAxis.nearest(normal);
        Vec3 first = axis.with(Snap.place(context, pointer, at), baseMetres);
        return new DrawnBox(axis, first, first, Math.signum(axis.of(normal)) * defaultHeight());
    }

    /** A vertex of the face is exact where the place of the pick is rounded; a sloped face has the place itself. */
    private double height(Picker.Pick surface, WorldAxis axis) {
        if (Math.abs(axis.of(surface.normal())) < 1) {
            return axis.of(surface.point());
        }
        return context.shapes().brushes().stream()
                .filter(brush -> brush.solidId().equals(surface.entity().id()))
                .flatMap(brush -> brush.faces().stream())
                .filter(face -> face.name().equals(surface.face()))
                .findFirst()
                .map(face -> axis.of(face.polygon().get(0)))
                .orElse(axis.of(surface.point()));
    }

    private Optional<DrawnBox> inPlan(Pointer pointer) {
        Vec3 forward = pointer.camera().forward();
        WorldAxis axis = WorldAxis.nearest(forward);
        Aabb depth = depth();
        double from = depth.isEmpty() ? -wall() : axis.least(depth);
        double metres = depth.isEmpty() ? planDepth() : axis.most(depth) - from;
        return pointer.onPlane(axis.with(Vec3.ZERO, from), forward).map(at -> {
            Vec3 first = axis.with(Snap.place(context, pointer, at), from);
            return new DrawnBox(
                    axis, first, first, metres > 0 ? metres : context.grid().stepMetres());
        });
    }

    private Aabb depth() {
        Snapshot now = context.document().now();
        return last.isEmpty() ? EntityBounds.of(now.level(), now.selection().entities()) : last;
    }

    private double planDepth() {
        return wall() > 0 ? defaultHeight() : context.grid().stepMetres();
    }

    private double defaultHeight() {
        return wall() > 0
                ? ROOM_METRES + 2 * wall()
                : HEIGHT_STEPS * context.grid().stepMetres();
    }

    /** Returns the thickness of the walls of a room, whose floor is then at a height of zero; zero for other shapes. */
    private double wall() {
        return context.options().shape() instanceof ShapeOptions.Room room ? room.wallMetres() : 0;
    }

    @Override
    public void dragged(Pointer pointer) {
        if (box == null) {
            return;
        }
        boolean isHigher = pointer.isHeld(Modifier.ALT) && !pointer.isPlan() && !box.isFlat();
        box = (isHigher ? higher(pointer) : wider(pointer)).orElse(box);
        show(box);
    }

    private Optional<DrawnBox> higher(Pointer pointer) {
        return pointer.alongLine(box.second(), box.axis().unit())
                .map(metres -> Snap.length(context, metres))
                .filter(metres -> metres != 0)
                .map(box::withHeight);
    }

    private Optional<DrawnBox> wider(Pointer pointer) {
        return pointer.onPlane(box.first(), box.axis().unit())
                .map(at -> box.withSecond(Snap.place(context, pointer, at)))
                .map(free -> pointer.isHeld(Modifier.SHIFT) ? free.square() : free);
    }

    private void show(DrawnBox drawn) {
        if (drawn.isFlat()) {
            context.document().cancelDrag();
            return;
        }
        context.document().drag(before -> {
            BrushEdit<List<Solid>> made = solids(before.level(), drawn.bounds());
            context.status(made.refusal().map(BrushText::words).orElse(Words.NONE));
            return made.result().map(solids -> with(before, solids)).orElse(before);
        });
    }

    private BrushEdit<List<Solid>> solids(Level level, Aabb bounds) {
        BrushStyle style = context.options().style(level);
        String wish = context.options().shape().getClass().getSimpleName().toLowerCase(Locale.ROOT);
        Set<String> taken = new HashSet<>();
        BrushEdit<List<Solid>> drawn =
                BrushShapes.drawn(bounds, context.options().shape(), style, () -> {
                    String id = Entities.LEVEL.freshId(level, Picker.SOLIDS, wish, taken);
                    taken.add(id);
                    return id;
                });
        return context.options().shape() instanceof ShapeOptions.Room
                ? drawn.map(slabs -> BrushShapes.named(
                        slabs, bounds, side -> Entities.LEVEL.freshId(level, Picker.SOLIDS, wish + "-" + side)))
                : drawn;
    }

    private Snapshot with(Snapshot before, List<Solid> solids) {
        Level level = MaterialLibrary.STANDARD.including(
                before.level(), context.options().material());
        List<EntityRef> made = new ArrayList<>();
        for (Solid solid : solids) {
            level = Entities.LEVEL.added(level, Picker.SOLIDS, (Record) solid);
            made.add(new EntityRef(Picker.SOLIDS, solid.id()));
        }
        return new Snapshot(level, Selection.of(made));
    }

    @Override
    public void released(Pointer pointer) {
        if (box != null && context.document().isDragging()) {
            last = box.bounds();
            context.document().commitDrag(DRAW);
        }
        box = null;
    }

    @Override
    public void cancel() {
        context.document().cancelDrag();
        box = null;
        corner = null;
    }

    @Override
    public List<Mark> marks() {
        if (box == null) {
            return corner == null ? List.of() : List.of(new Mark.Handle(corner, MarkColour.PREVIEW));
        }
        Aabb bounds = box.bounds();
        String size = metres(bounds.maxX() - bounds.minX()) + " × " + metres(bounds.maxY() - bounds.minY()) + " × "
                + metres(bounds.maxZ() - bounds.minZ()) + " m";
        return List.of(new Mark.Label(bounds.centre(), size, MarkColour.GUIDE));
    }

    private static String metres(double length) {
        return new BigDecimal(length)
                .round(new MathContext(4))
                .stripTrailingZeros()
                .toPlainString();
    }

    @Override
    public Words hint() {
        return ENTRY.description();
    }

    /**
     * The box between a corner on a plane and the pointer.
     *
     * @param axis perpendicular to the plane of the base
     * @param first corner on the base
     * @param second corner opposite to it on the base
     * @param heightMetres from the base along the axis; negative against it
     */
    private record DrawnBox(WorldAxis axis, Vec3 first, Vec3 second, double heightMetres) {
        DrawnBox withSecond(Vec3 corner) {
            return new DrawnBox(axis, first, axis.with(corner, axis.of(first)), heightMetres);
        }

        DrawnBox withHeight(double metres) {
            return new DrawnBox(axis, first, second, metres);
        }

        /** Returns this box with the shorter side of its base as long as the longer one. */
        DrawnBox square() {
            Vec3 by = second.minus(first);
            double side = Math.max(Math.abs(by.x()), Math.max(Math.abs(by.y()), Math.abs(by.z())));
            Vec3 corner = first;
            for (WorldAxis across : WorldAxis.values()) {
                if (across != axis) {
                    corner = across.with(corner, across.of(first) + (across.of(by) < 0 ? -side : side));
                }
            }
            return withSecond(corner);
        }

        /** Returns true if the box encloses nothing. */
        boolean isFlat() {
            Aabb box = bounds();
            return box.minX() == box.maxX() || box.minY() == box.maxY() || box.minZ() == box.maxZ();
        }

        Aabb bounds() {
            return Aabb.of(List.of(first, axis.with(second, axis.of(first) + heightMetres)));
        }
    }
}
