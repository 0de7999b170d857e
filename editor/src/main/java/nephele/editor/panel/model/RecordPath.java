package nephele.editor.panel.model;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import nephele.editor.record.RecordField;
import nephele.editor.record.RecordKind;

/** The path from a record to a value inside it, through nested records, lists and tables. */
public record RecordPath(List<Step> steps) {
    /** The record itself. */
    public static final RecordPath SELF = new RecordPath(List.of());

    /**
     * A component, or an entry of it.
     *
     * @param entry index in a list or key in a table; {@code null} for the component's whole value
     */
    public record Step(String component, Object entry) {}

    public RecordPath {
        steps = List.copyOf(steps);
    }

    /** Returns the path of a component of the record at this path. */
    public RecordPath component(String name) {
        return new RecordPath(
                Stream.concat(steps.stream(), Stream.of(new Step(name, null))).toList());
    }

    /** Returns the path of an entry of the list or table at this path. */
    public RecordPath entry(Object entry) {
        return withLast(new Step(last().component, entry));
    }

    /** Returns the path of the list or table that has the entry at this path. */
    public RecordPath owner() {
        return withLast(new Step(last().component, null));
    }

    /** Returns the last step. */
    public Step last() {
        return steps.get(steps.size() - 1);
    }

    private RecordPath withLast(Step step) {
        List<Step> changed = new ArrayList<>(steps);
        changed.set(steps.size() - 1, step);
        return new RecordPath(changed);
    }

    /** Returns the value at this path, or {@code null} if there is none. */
    public Object get(Record root) {
        Object value = root;
        for (Step step : steps) {
            if (!(value instanceof Record owner)) {
                return null;
            }
            RecordKind kind = RecordKind.of(owner);
            value = kind.field(step.component)
                    .map(field -> kind.get(owner, field))
                    .orElse(null);
            value = step.entry == null ? value : entry(value, step.entry);
        }
        return value;
    }

    private static Object entry(Object collection, Object entry) {
        if (collection instanceof List<?> list) {
            return entry instanceof Integer index && index < list.size() ? list.get(index) : null;
        }
        return collection instanceof Map<?, ?> table ? table.get(entry) : null;
    }

    /** Returns the record with the value at this path changed; the same record if it has no such place. */
    public Record changed(Record root, UnaryOperator<Object> change) {
        return steps.isEmpty() ? (Record) change.apply(root) : changed(root, 0, change);
    }

    private Record changed(Record owner, int depth, UnaryOperator<Object> change) {
        Step step = steps.get(depth);
        RecordKind kind = RecordKind.of(owner);
        Optional<RecordField> field = kind.field(step.component);
        if (field.isEmpty()) {
            return owner;
        }
        Object before = kind.get(owner, field.get());
        UnaryOperator<Object> deeper = value -> {
            if (depth == steps.size() - 1) {
                return change.apply(value);
            }
            return value instanceof Record nested ? changed(nested, depth + 1, change) : value;
        };
        Object after = step.entry == null ? deeper.apply(before) : withEntry(before, step.entry, deeper);
        return after == before || (after != null && after.equals(before))
                ? owner
                : kind.with(owner, field.get(), after);
    }

    private static Object withEntry(Object collection, Object entry, UnaryOperator<Object> change) {
        if (collection instanceof List<?> list && entry instanceof Integer index && index < list.size()) {
            List<Object> changed = new ArrayList<>(list);
            changed.set(index, change.apply(list.get(index)));
            return List.copyOf(changed);
        } else if (collection instanceof Map<?, ?> table && table.containsKey(entry)) {
            Map<Object, Object> changed = new LinkedHashMap<>(table);
            changed.put(entry, change.apply(table.get(entry)));
            return java.util.Collections.unmodifiableMap(changed);
        }
        return collection;
    }
}
