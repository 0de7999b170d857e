package nephele.editor.added;

import java.util.List;
import java.util.Map;
import nephele.editor.document.EntityTransform;
import nephele.editor.record.FieldKind;
import nephele.editor.record.RecordField;
import nephele.editor.record.RecordKind;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Environment.Lightning;
import nephele.engine.level.Exposure;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Solid;
import nephele.engine.level.Spatial;
import nephele.engine.math.Vec3;

/** New records at a place, made from their declarations; a few need more than the prototypes of their components. */
public final class NewRecord {
    private static final double HALF_METRES = 0.5;

    private NewRecord() {}

    /** Returns a new record at a place, metres; a record without an id ignores it. */
    public static Record at(RecordKind kind, String id, Vec3 at) {
        Record record = declared(kind, id, at);
        if (record instanceof ModelPlacement) {
            return at.equals(Vec3.ZERO) ? record : EntityTransform.moved(record, at);
        } else if (record instanceof Solid.Planes planes) {
            return cube(planes, at);
        }
        return record instanceof Lightning lightning ? above(lightning) : record;
    }

    /** Planes without a single one enclose nothing. */
    private static Record cube(Solid.Planes none, Vec3 at) {
        Vec3 centre = at.plus(new Vec3(0, HALF_METRES, 0));
        List<Solid.PlaneFace> planes = List.of(BoxFace.values()).stream()
                .map(side ->
                        new Solid.PlaneFace(side.normal(), side.normal().dot(centre) + HALF_METRES, null, null, null))
                .toList();
        return new Solid.Planes(none.id(), none.material(), none.portalable(), none.textureMapping(), planes);
    }

    /** Bolts end below the box in which they begin. */
    private static Record above(Lightning lightning) {
        double up = lightning.groundAltitudeMetres()
                + 2 * lightning.size().y()
                - lightning.centre().y();
        return up > 0 ? EntityTransform.moved(lightning, new Vec3(0, up, 0)) : lightning;
    }

    /** Returns the record of the absent values, prototypes and places that its components declare. */
    private static Record declared(RecordKind kind, String id, Vec3 at) {
        Object[] values = new Object[kind.fields().size()];
        boolean isTarget = false;
        for (RecordField field : kind.fields()) {
            Object value = value(field, id, at);
            if (field.spatial() == Spatial.POINT && field.isRequired()) {
                // Two equal points, such as a camera's position and target, would give no direction.
                value = isTarget ? at.plus(new Vec3(0, 0, -1)) : at;
                isTarget = true;
            }
            if (field.spatial() == Spatial.POINT && field.kind() == FieldKind.LIST) {
                value = List.of(at);
            }
            values[field.index()] = value;
        }
        return kind.make(values);
    }

    private static Object value(RecordField field, String id, Vec3 at) {
        if (field.isId()) {
            return id;
        }
        if (!field.isRequired() && field.written().prototype() == null) {
            return field.declaration().beside()
                    ? nested(field, id, at)
                    : field.written().absent();
        }
        return field.written().prototype() != null ? field.written().prototype() : derived(field, id, at);
    }

    private static Record nested(RecordField field, String id, Vec3 at) {
        List<Class<?>> classes = field.recordClasses();
        return declared(RecordKind.of(classes.get(classes.size() - 1)), id, at);
    }

    private static Object derived(RecordField field, String id, Vec3 at) {
        double number = field.range() == null ? 1 : field.range().nearest(1);
        return switch (field.kind()) {
            case NUMBER -> number;
            case WHOLE -> field.valueClass() == int.class ? (Object) (int) number : (Object) (long) number;
            case TRUTH -> false;
            case TEXT, REFERENCE, ASSET -> id.isEmpty() ? "new" : id;
            case CHOICE -> field.choices().get(0);
            case VECTOR -> field.spatial() == Spatial.DIRECTION ? new Vec3(0, 1, 0) : new Vec3(number, number, number);
            case EXPOSURE -> Exposure.NEUTRAL;
            case RECORD, VARIANT -> nested(field, id, at);
            case LIST -> List.of();
            case TABLE -> Map.of();
        };
    }
}
