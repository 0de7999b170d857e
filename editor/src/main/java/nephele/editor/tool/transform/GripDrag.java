package nephele.editor.tool.transform;

import java.util.Optional;
import java.util.function.UnaryOperator;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Pointer.Modifier;
import nephele.editor.tool.PointerDrag;
import nephele.editor.tool.Snap;
import nephele.editor.tool.SnappedMove;
import nephele.editor.tool.ToolContext;
import nephele.editor.tool.WorldAxis;
import nephele.editor.transform.EntityTransform;
import nephele.engine.math.Vec3;

/** Maps the drag of a grip to a transform of entities. */
record GripDrag(ToolContext context, Grip.Constraint constraint, Pointer start) {
    private static final double TURN_DEGREES = 15;
    private static final double FINE_TURN_DEGREES = 5;

    /** Returns the change of each entity; empty where the pointer has no meaning, as over the horizon of the plane. */
    Optional<UnaryOperator<Record>> change(Pointer now) {
        return switch (constraint.kind()) {
            case MOVE_ALONG ->
                along(now).map(metres -> moved(constraint.direction().scaled(metres)));
            case MOVE_IN_PLANE -> inPlane(now).map(GripDrag::moved);
            case TURN -> degrees(now).map(this::turned);
            case SCALE_AXIS -> factor(now).map(this::scaledAlong);
            case SCALE_ALL -> factor(now).map(f -> scaled(new Vec3(f, f, f)));
        };
    }

    private SnappedMove move() {
        return new SnappedMove(context, constraint.origin());
    }

    private Optional<Double> along(Pointer now) {
        return between(now).map(metres -> move().length(now, constraint.direction(), metres));
    }

    /** Returns the movement along the direction, in lengths of it. */
    private Optional<Double> between(Pointer now) {
        Optional<Double> from = PointerDrag.alongLine(start, constraint.origin(), constraint.direction());
        return from.flatMap(begin -> PointerDrag.alongLine(now, constraint.origin(), constraint.direction())
                .map(end -> end - begin));
    }

    private Optional<Vec3> inPlane(Pointer now) {
        Vec3 normal = constraint.direction();
        WorldAxis axis = WorldAxis.nearest(normal);
        return PointerDrag.onPlane(start, constraint.origin(), normal)
                .flatMap(from -> PointerDrag.onPlane(now, constraint.origin(), normal)
                        .map(to -> axis.with(move().offset(now, to.minus(from)), 0)));
    }

    private Optional<Double> degrees(Pointer now) {
        Vec3 axis = constraint.direction();
        double step = now.isHeld(Modifier.SHIFT) ? FINE_TURN_DEGREES : TURN_DEGREES;
        return PointerDrag.onPlane(start, constraint.origin(), axis)
                .flatMap(from -> PointerDrag.onPlane(now, constraint.origin(), axis)
                        .map(to -> step * Math.rint(angle(from, to) / step)));
    }

    private double angle(Vec3 from, Vec3 to) {
        Vec3 a = from.minus(constraint.origin());
        Vec3 b = to.minus(constraint.origin());
        return Math.toDegrees(Math.atan2(a.cross(b).dot(constraint.direction()), a.dot(b)));
    }

    /** Returns how many times as long the longest side becomes: it snaps, and stays at least a step. */
    private Optional<Double> factor(Pointer now) {
        Vec3 sides = constraint.direction();
        double size = Math.abs(WorldAxis.nearest(sides).of(sides));
        double least = Math.min(context.grid().stepMetres(), size);
        return between(now).map(by -> by == 0 ? 1 : Math.max(least, Snap.length(context, size * (1 + by))) / size);
    }

    private UnaryOperator<Record> scaledAlong(double factor) {
        WorldAxis axis = WorldAxis.nearest(constraint.direction());
        return scaled(axis.with(new Vec3(1, 1, 1), factor));
    }

    private UnaryOperator<Record> scaled(Vec3 factors) {
        return factors.equals(new Vec3(1, 1, 1))
                ? UnaryOperator.identity()
                : entity -> EntityTransform.scaled(entity, constraint.origin(), factors);
    }

    private UnaryOperator<Record> turned(double degrees) {
        return degrees == 0
                ? UnaryOperator.identity()
                : entity -> EntityTransform.turned(entity, constraint.origin(), constraint.direction(), degrees);
    }

    private static UnaryOperator<Record> moved(Vec3 by) {
        return by.equals(Vec3.ZERO) ? UnaryOperator.identity() : entity -> EntityTransform.moved(entity, by);
    }
}
