package nephele.editor.record;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Maps the plain values inside a record, those of nested records, lists and tables included. */
public final class RecordWalk {
    private RecordWalk() {}

    /** The change of a plain value. */
    @FunctionalInterface
    public interface ValueChange {
        /** Returns the value's replacement, or the same object for no change; the value may be {@code null}. */
        Object changed(RecordField field, Object value);
    }

    /** Returns the record with all plain values changed; the same object if nothing differs. */
    public static Record map(Record owner, ValueChange change) {
        RecordKind kind = RecordKind.of(owner);
        Object[] values = kind.values(owner);
        boolean differs = false;
        for (RecordField field : kind.fields()) {
            Object before = values[field.index()];
            Object after = mapped(field, before, change);
            values[field.index()] = after;
            differs |= after != before;
        }
        return differs ? kind.make(values) : owner;
    }

    private static Object mapped(RecordField field, Object value, ValueChange change) {
        if (value instanceof Record nested && !field.recordClasses().isEmpty()) {
            return map(nested, change);
        } else if (value instanceof List<?> list) {
            return list(field, list, change);
        } else if (value instanceof Map<?, ?> table) {
            return table(field, table, change);
        }
        return change.changed(field, value);
    }

    private static Object list(RecordField field, List<?> list, ValueChange change) {
        List<Object> changed = new ArrayList<>(list.size());
        boolean differs = false;
        for (Object element : list) {
            Object after = element(field, element, change);
            differs |= after != element;
            changed.add(after);
        }
        return differs ? List.copyOf(changed) : list;
    }

    private static Object table(RecordField field, Map<?, ?> table, ValueChange change) {
        Map<Object, Object> changed = new LinkedHashMap<>();
        boolean[] differs = {false};
        table.forEach((key, value) -> {
            Object after = element(field, value, change);
            differs[0] |= after != value;
            changed.put(key, after);
        });
        return differs[0] ? java.util.Collections.unmodifiableMap(changed) : table;
    }

    private static Object element(RecordField field, Object element, ValueChange change) {
        boolean isRecord = element instanceof Record && !field.recordClasses().isEmpty();
        return isRecord ? map((Record) element, change) : change.changed(field, element);
    }
}
