package nephele.editor.tool;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import nephele.editor.document.EntityBounds;
import nephele.editor.document.LevelShapes;
import nephele.editor.document.Picker;
import nephele.editor.document.Snapshot;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.tool.ToolOptions.Snapping;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * Snaps the displacement of the selected entities: their vertex nearest to the pointer goes to one under it, or they
 * come to rest on the surface under it, or to lie on the grid, or are displaced by multiples of its step.
 */
public final class SnappedMove {
    private static final double PARALLEL = 1e-6;

    private final ToolContext context;
    private final Snapshot start;
    private final Vec3 grabbed;

    /** @param grabbed the place at which the pointer holds the entities before they move */
    public SnappedMove(ToolContext context, Vec3 grabbed) {
        this.context = context;
        this.grabbed = grabbed;
        start = context.document().history().current();
    }

    /** Returns the displacement by a free drag, snapped in the directions in which it goes. */
    public Vec3 offset(Pointer pointer, Vec3 by) {
        Optional<Vec3> toVertex = toVertex(pointer);
        if (toVertex.isPresent()) {
            return toVertex.get();
        }
        Vec3 onGrid = onGrid(by);
        return surface(pointer)
                .map(pick -> onGrid.addScaled(height(pick, onGrid), pick.normal()))
                .map(PointedPlace::cleaned)
                .orElse(onGrid);
    }

    /** Returns the length of a displacement along a direction of unit length. */
    public double length(Pointer pointer, Vec3 direction, double metres) {
        Optional<Vec3> toVertex = toVertex(pointer);
        if (toVertex.isPresent()) {
            return toVertex.get().dot(direction);
        }
        Optional<Double> toSurface = surface(pointer)
                .filter(pick -> Math.abs(pick.normal().dot(direction)) > PARALLEL)
                .map(pick -> height(pick, Vec3.ZERO) / pick.normal().dot(direction));
        if (toSurface.isPresent()) {
            return toSurface.get();
        }
        return Snap.is(context, Snapping.ABSOLUTE)
                ? onGrid(direction.scaled(metres)).dot(direction)
                : Snap.length(context, metres);
    }

    private Optional<Vec3> toVertex(Pointer pointer) {
        if (!Snap.is(context, Snapping.VERTEX)) {
            return Optional.empty();
        }
        return Snap.vertex(context, pointer, moving()).flatMap(target -> own().map(target::minus));
    }

    /** Returns the vertex of the selected brushes nearest to where the pointer holds them. */
    private Optional<Vec3> own() {
        Vec3 nearest = null;
        for (EntityRef ref : start.selection().entities()) {
            Optional<Brush> brush = Entities.LEVEL
                    .find(start.level(), ref)
                    .filter(Solid.class::isInstance)
                    .flatMap(solid -> LevelShapes.brushOf((Solid) solid));
            for (Vec3 vertex : brush.map(shape -> shape.shape().vertices()).orElse(List.of())) {
                boolean isNearer = nearest == null
                        || vertex.minus(grabbed).length()
                                < nearest.minus(grabbed).length();
                nearest = isNearer ? vertex : nearest;
            }
        }
        return Optional.ofNullable(nearest);
    }

    private Optional<Picker.Pick> surface(Pointer pointer) {
        if (!Snap.is(context, Snapping.SURFACE) || pointer.isPlan()) {
            return Optional.empty();
        }
        Set<EntityRef> moving = moving();
        return context.picker().surfaces(pointer.ray()).stream()
                .filter(pick -> !moving.contains(pick.entity()))
                .findFirst();
    }

    /** Returns how far along the normal the displaced entities are from resting on a surface. */
    private double height(Picker.Pick surface, Vec3 by) {
        Aabb box = bounds();
        if (box.isEmpty()) {
            return 0;
        }
        Vec3 normal = surface.normal();
        Vec3 lowest = new Vec3(
                normal.x() > 0 ? box.minX() : box.maxX(),
                normal.y() > 0 ? box.minY() : box.maxY(),
                normal.z() > 0 ? box.minZ() : box.maxZ());
        return surface.point().minus(lowest.plus(by)).dot(normal);
    }

    private Vec3 onGrid(Vec3 by) {
        Aabb box = bounds();
        if (!Snap.is(context, Snapping.ABSOLUTE) || box.isEmpty()) {
            return Snap.offset(context, by);
        }
        return new Vec3(onGrid(box.minX(), by.x()), onGrid(box.minY(), by.y()), onGrid(box.minZ(), by.z()));
    }

    /** A direction in which nothing moves stays as it is, on the grid or not. */
    private double onGrid(double from, double by) {
        return by == 0 ? 0 : context.grid().snapped(from + by) - from;
    }

    private Aabb bounds() {
        return EntityBounds.of(start.level(), start.selection().entities());
    }

    private Set<EntityRef> moving() {
        return new HashSet<>(start.selection().entities());
    }
}
