package nephele.editor.record;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import nephele.engine.level.Exposure;
import nephele.engine.level.json.WrittenRecord;
import nephele.engine.math.Vec3;

/** A record class of the level: reads and replaces components of its records by name. */
public final class RecordKind {
    private static final ClassValue<RecordKind> KINDS = new ClassValue<>() {
        @Override
        protected RecordKind computeValue(Class<?> type) {
            return new RecordKind(type);
        }
    };

    private final Class<?> type;
    private final WrittenRecord written;
    private final List<RecordField> fields;
    /** {@code null} if the records have none. */
    private final RecordField idField;

    private RecordKind(Class<?> type) {
        this.type = type;
        this.written = WrittenRecord.of(type);
        List<RecordField> found = new ArrayList<>();
        for (int i = 0; i < written.fields().size(); i++) {
            found.add(RecordField.of(i, written.fields().get(i)));
        }
        fields = List.copyOf(found);
        idField = fields.stream().filter(RecordField::isId).findFirst().orElse(null);
    }

    /** Returns the kind of a record class. */
    public static RecordKind of(Class<?> type) {
        return KINDS.get(type);
    }

    /** Returns the kind of a record. */
    public static RecordKind of(Record value) {
        return KINDS.get(value.getClass());
    }

    /**
     * Returns the record classes of a type: itself, or those of a sealed interface in the order of their names. A vector
     * and an exposure are plain values.
     */
    static List<Class<?>> classesOf(Class<?> type) {
        if (type.isRecord()) {
            return type == Vec3.class || type == Exposure.class ? List.of() : List.of(type);
        }
        if (!type.isSealed()) {
            return List.of();
        }
        List<Class<?>> classes = new ArrayList<>(Arrays.asList(type.getPermittedSubclasses()));
        classes.sort(Comparator.comparing(Class::getSimpleName));
        return classes;
    }

    public Class<?> type() {
        return type;
    }

    /** Returns the word for {@code kind} in files, such as {@code box}. */
    public String name() {
        return type.getSimpleName().toLowerCase(Locale.ROOT);
    }

    public List<RecordField> fields() {
        return fields;
    }

    public Optional<RecordField> field(String name) {
        return fields.stream().filter(field -> field.name().equals(name)).findFirst();
    }

    public Object get(Record owner, RecordField field) {
        return written.value(owner, field.index());
    }

    /** Returns the values of all components, in the order of {@link #fields}. */
    public Object[] values(Record owner) {
        return written.values(owner);
    }

    /** Returns the record with another value of one component. */
    public Record with(Record owner, RecordField field, Object value) {
        Object[] values = written.values(owner);
        values[field.index()] = value;
        return written.make(values);
    }

    /** Returns the record with another value of the component of this name. */
    public static <R extends Record> R with(R owner, String name, Object value) {
        RecordKind kind = of(owner);
        @SuppressWarnings("unchecked") // a kind makes records of its own class
        R changed = (R) kind.with(owner, kind.field(name).orElseThrow(), value);
        return changed;
    }

    /** Returns the record with these components, which are in the order of {@link #fields}. */
    public Record make(Object[] values) {
        return written.make(values);
    }

    /** Returns the id of a record; empty if it has none. */
    public static String id(Record value) {
        RecordKind kind = of(value);
        return kind.idField == null ? "" : (String) kind.get(value, kind.idField);
    }
}
