package nephele.editor.record;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import nephele.engine.level.Exposure;
import nephele.engine.level.json.WrittenRecord;
import nephele.engine.math.Vec3;

/** A record class of the level: reads and replaces components of its records by name, or all plain values in them. */
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
        if (!type.isSealed() || type.isEnum()) { // an enum whose constants have bodies is sealed, too
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
    @SuppressWarnings("unchecked") // a kind makes records of its own class
    public <R extends Record> R with(R owner, RecordField field, Object value) {
        Object[] values = written.values(owner);
        values[field.index()] = value;
        return (R) written.make(values);
    }

    /** Returns the record with another value of the component of this name. */
    public static <R extends Record> R with(R owner, String name, Object value) {
        RecordKind kind = of(owner);
        return kind.with(owner, kind.field(name).orElseThrow(), value);
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

    /**
     * Returns a record with all plain values in it changed, those of nested records, lists and tables included; the same
     * object if nothing differs.
     *
     * @param change returns a value's replacement, or the same object for none; the value may be {@code null}
     */
    @SuppressWarnings("unchecked") // a kind makes records of its own class
    public static <R extends Record> R mapped(R owner, BiFunction<RecordField, Object, Object> change) {
        RecordKind kind = RecordKind.of(owner);
        Object[] values = kind.values(owner);
        boolean differs = false;
        for (RecordField field : kind.fields()) {
            Object before = values[field.index()];
            Object after = mapped(field, before, change);
            values[field.index()] = after;
            differs |= after != before;
        }
        return differs ? (R) kind.make(values) : owner;
    }

    private static Object mapped(RecordField field, Object value, BiFunction<RecordField, Object, Object> change) {
        if (value instanceof Record nested && !field.recordClasses().isEmpty()) {
            return mapped(nested, change);
        } else if (value instanceof List<?> list) {
            return list(field, list, change);
        } else if (value instanceof Map<?, ?> table) {
            return table(field, table, change);
        }
        return change.apply(field, value);
    }

    private static Object list(RecordField field, List<?> list, BiFunction<RecordField, Object, Object> change) {
        List<Object> changed = new ArrayList<>(list.size());
        boolean differs = false;
        for (Object element : list) {
            Object after = element(field, element, change);
            differs |= after != element;
            changed.add(after);
        }
        return differs ? List.copyOf(changed) : list;
    }

    private static Object table(RecordField field, Map<?, ?> table, BiFunction<RecordField, Object, Object> change) {
        Map<Object, Object> changed = new LinkedHashMap<>();
        boolean[] differs = {false};
        table.forEach((key, value) -> {
            Object after = element(field, value, change);
            differs[0] |= after != value;
            changed.put(key, after);
        });
        return differs[0] ? Collections.unmodifiableMap(changed) : table;
    }

    private static Object element(RecordField field, Object element, BiFunction<RecordField, Object, Object> change) {
        boolean isRecord = element instanceof Record && !field.recordClasses().isEmpty();
        return isRecord ? mapped((Record) element, change) : change.apply(field, element);
    }
}
