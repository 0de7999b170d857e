package nephele.editor.record;

import java.util.List;
import java.util.Map;
import nephele.engine.level.Exposure;
import nephele.engine.level.Spatial;
import nephele.engine.math.Vec3;

/** Makes the record of a new entity from its declaration: absent values, prototypes, and a place. */
public final class Prototypes {
    private Prototypes() {}

    /**
     * Returns a new record.
     *
     * @param id its id, ignored by a record without one
     * @param at where it is made, metres
     */
    public static Record make(RecordKind kind, String id, Vec3 at) {
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
        return make(RecordKind.of(classes.get(classes.size() - 1)), id, at);
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
