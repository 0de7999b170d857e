package nephele.editor.document;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import nephele.editor.brush.LockableTransform;
import nephele.editor.brush.SolidTransform;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.RecordField;
import nephele.editor.record.RecordKind;
import nephele.engine.level.Level;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.ModelPlacement.TransformStep;
import nephele.engine.level.Solid;
import nephele.engine.level.Spatial;
import nephele.engine.math.Vec3;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/** Moves, turns and scales entities: solids by their shapes, models by their steps, all others by their components. */
public final class EntityTransform {
    private EntityTransform() {}

    /** Returns the level with entities moved. */
    public static Level moved(Level level, Collection<EntityRef> refs, Vec3 by) {
        return by.equals(Vec3.ZERO) ? level : Entities.LEVEL.changed(level, refs, entity -> moved(entity, by));
    }

    /** Returns the level with entities moved, textures fixed to their brushes or to the world. */
    public static Level moved(Level level, Collection<EntityRef> refs, Vec3 by, boolean isTextureLocked) {
        if (by.equals(Vec3.ZERO)) {
            return level;
        }
        LockableTransform solids = LockableTransform.of(isTextureLocked, level.materials());
        return Entities.LEVEL.changed(
                level,
                refs,
                entity -> entity instanceof Solid solid ? (Record) solids.moved(solid, by) : moved(entity, by));
    }

    /** Returns the level with entities turned; a solid that cannot be turned stays as it is. */
    public static Level turned(
            Level level, Collection<EntityRef> refs, Vec3 pivot, Vec3 axis, double degrees, boolean isTextureLocked) {
        LockableTransform solids = LockableTransform.of(isTextureLocked, level.materials());
        return Entities.LEVEL.changed(
                level,
                refs,
                entity -> entity instanceof Solid solid
                        ? (Record) solids.rotated(solid, pivot, axis, degrees)
                                .result()
                                .orElse(solid)
                        : turned(entity, pivot, axis, degrees));
    }

    /** Returns an entity moved by a vector, metres. */
    public static Record moved(Record entity, Vec3 by) {
        if (entity instanceof Solid solid) {
            return (Record) SolidTransform.moved(solid, by);
        } else if (entity instanceof ModelPlacement model) {
            return moved(model, by);
        }
        return points(entity, point -> point.plus(by));
    }

    /** Returns an entity turned about a pivot; a solid that cannot be turned stays as it is. */
    public static Record turned(Record entity, Vec3 pivot, Vec3 axis, double degrees) {
        if (entity instanceof Solid solid) {
            return (Record)
                    SolidTransform.rotated(solid, pivot, axis, degrees).result().orElse(solid);
        } else if (entity instanceof ModelPlacement model) {
            return turned(model, pivot, axis, degrees);
        }
        Turn turn = new Turn(pivot, axis, degrees);
        return RecordKind.mapped(entity, (field, value) -> turned(field, value, turn));
    }

    private static Object turned(RecordField field, Object value, Turn turn) {
        if (!(value instanceof Vec3 vector)) {
            return field.name().equals("yawDegrees") ? (Object) ((double) value + turn.yawDegrees()) : value;
        }
        return switch (field.spatial()) {
            case POINT -> turn.point(vector);
            case DIRECTION -> turn.direction(vector);
            case EXTENT -> turn.extent(vector);
            case NONE, LENGTH -> vector;
        };
    }

    /** Returns an entity scaled about a pivot; a solid that cannot be scaled stays as it is. */
    public static Record scaled(Record entity, Vec3 pivot, Vec3 factors) {
        if (entity instanceof Solid solid) {
            return (Record)
                    SolidTransform.scaled(solid, pivot, factors).result().orElse(solid);
        } else if (entity instanceof ModelPlacement model) {
            List<TransformStep> steps = new ArrayList<>();
            steps.add(new TransformStep.Translate(pivot));
            steps.add(new TransformStep.Scale(factors));
            steps.add(new TransformStep.Translate(pivot.negated()));
            return before(model, steps);
        }
        double length = Math.cbrt(Math.abs(factors.x() * factors.y() * factors.z()));
        return RecordKind.mapped(entity, (field, value) -> scaled(field, value, pivot, factors, length));
    }

    private static Object scaled(RecordField field, Object value, Vec3 pivot, Vec3 factors, double length) {
        if (field.spatial() == Spatial.LENGTH && value instanceof Double metres) {
            return field.range().nearest(metres * length);
        } else if (field.spatial() == Spatial.POINT && value instanceof Vec3 point) {
            return pivot.plus(point.minus(pivot).times(factors));
        } else if (field.spatial() == Spatial.EXTENT && value instanceof Vec3 size) {
            Vec3 scaled = size.times(factors);
            return new Vec3(
                    field.range().nearest(Math.abs(scaled.x())),
                    field.range().nearest(Math.abs(scaled.y())),
                    field.range().nearest(Math.abs(scaled.z())));
        }
        return value;
    }

    private static Record points(Record entity, java.util.function.UnaryOperator<Vec3> change) {
        return RecordKind.mapped(
                entity,
                (field, value) ->
                        field.spatial() == Spatial.POINT && value instanceof Vec3 point ? change.apply(point) : value);
    }

    /** A model with a parent moves in its parent's frame. */
    private static ModelPlacement moved(ModelPlacement model, Vec3 by) {
        List<TransformStep> steps = new ArrayList<>(model.transform());
        if (!steps.isEmpty() && steps.get(0) instanceof TransformStep.Translate first) {
            Vec3 sum = first.by().plus(by);
            steps.remove(0);
            if (!sum.equals(Vec3.ZERO)) {
                steps.add(0, new TransformStep.Translate(sum));
            }
        } else {
            steps.add(0, new TransformStep.Translate(by));
        }
        return with(model, steps);
    }

    private static ModelPlacement turned(ModelPlacement model, Vec3 pivot, Vec3 axis, double degrees) {
        return before(
                model,
                List.of(
                        new TransformStep.Translate(pivot),
                        new TransformStep.Rotate(axis, degrees),
                        new TransformStep.Translate(pivot.negated())));
    }

    private static ModelPlacement before(ModelPlacement model, List<TransformStep> outer) {
        List<TransformStep> steps = new ArrayList<>(outer);
        steps.addAll(model.transform());
        return with(model, steps);
    }

    private static ModelPlacement with(ModelPlacement model, List<TransformStep> steps) {
        return model.withTransform(List.copyOf(steps));
    }

    /** A rotation about an axis through a pivot; quarter turns about an axis of the world are exact. */
    record Turn(Vec3 pivot, Vec3 axis, double degrees) {
        Vec3 point(Vec3 p) {
            return pivot.plus(direction(p.minus(pivot)));
        }

        Vec3 direction(Vec3 v) {
            Vec3 turned = Vec3.of(rotation().transform(new Vector3d(v.x(), v.y(), v.z())));
            return degrees % 90 == 0 ? cleaned(turned) : turned;
        }

        /** Returns the size of the box around a box of this size after the turn. */
        Vec3 extent(Vec3 size) {
            Vec3 x = direction(new Vec3(size.x(), 0, 0));
            Vec3 y = direction(new Vec3(0, size.y(), 0));
            Vec3 z = direction(new Vec3(0, 0, size.z()));
            return new Vec3(
                    Math.abs(x.x()) + Math.abs(y.x()) + Math.abs(z.x()),
                    Math.abs(x.y()) + Math.abs(y.y()) + Math.abs(z.y()),
                    Math.abs(x.z()) + Math.abs(y.z()) + Math.abs(z.z()));
        }

        /** Returns the change of a yaw angle: the turn, if its axis is vertical. */
        double yawDegrees() {
            return axis.x() == 0 && axis.z() == 0 ? Math.signum(axis.y()) * degrees : 0;
        }

        private Quaterniond rotation() {
            return new Quaterniond().fromAxisAngleDeg(axis.x(), axis.y(), axis.z(), degrees);
        }

        private static Vec3 cleaned(Vec3 v) {
            return new Vec3(cleaned(v.x()), cleaned(v.y()), cleaned(v.z()));
        }

        /** Removes the rounding of a quarter turn's sine and cosine. */
        private static double cleaned(double value) {
            return Math.rint(value * 0x1p30) * 0x1p-30 + 0.0;
        }
    }
}
