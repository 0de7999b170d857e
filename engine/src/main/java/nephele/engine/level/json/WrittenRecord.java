package nephele.engine.level.json;

import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.NumberRange;
import nephele.engine.level.Range;
import nephele.engine.level.Written;

/**
 * A record class of the level format: its components, and making and taking apart its records. The editor builds its
 * palette, outliner and inspector from these alone.
 */
public final class WrittenRecord {
    private final RecordFormat format;
    private final List<WrittenField> fields = new ArrayList<>();

    private WrittenRecord(Class<?> type) {
        format = RecordFormat.of(type);
        RecordComponent[] components = type.getRecordComponents();
        for (int i = 0; i < components.length; i++) {
            RecordFormat.FieldFormat field = format.field(i);
            Written written = components[i].getAnnotation(Written.class);
            Object prototype =
                    written.prototype().isEmpty() ? null : field.format().parsed(written.prototype(), "prototype");
            Range range = components[i].getAnnotation(Range.class);
            fields.add(new WrittenField(
                    field.name(),
                    components[i].getGenericType(),
                    written,
                    range == null ? null : NumberRange.of(range),
                    field.absent(),
                    prototype));
        }
    }

    /**
     * Describes a record class.
     *
     * @throws IllegalStateException if a component has no {@link Written} annotation
     */
    public static WrittenRecord of(Class<?> type) {
        return new WrittenRecord(type);
    }

    /** Returns the components in their order. */
    public List<WrittenField> fields() {
        return List.copyOf(fields);
    }

    /** Returns the values of the components of a record. */
    public Object[] values(Object owner) {
        Object[] values = new Object[fields.size()];
        for (int i = 0; i < values.length; i++) {
            values[i] = format.field(i).get(owner);
        }
        return values;
    }

    /** Returns the value of one component of a record. */
    public Object value(Object owner, int index) {
        return format.field(index).get(owner);
    }

    /** Returns the record with these components, which are in the order of {@link #fields}. */
    public Record make(Object[] values) {
        return (Record) format.make(values);
    }
}
