package nephele.editor.record;

import java.util.List;

/**
 * A record that a level has once: always, such as {@code environment}, or at most once, such as {@code player}.
 *
 * @param path such as {@code environment.sun}; empty for the level itself
 * @param steps components from the level down to it
 * @param kinds the classes that it may have
 */
public record SingleSection(String path, List<RecordField> steps, List<RecordKind> kinds) {
    /** Returns the record, or {@code null} if the level has none. */
    public Record get(Record root) {
        Record value = root;
        for (RecordField step : steps) {
            value = (Record) RecordKind.of(value).get(value, step);
        }
        return value;
    }

    /** Returns the level with another record, or with none if it is {@code null}. */
    @SuppressWarnings("unchecked") // a record of the root's class is made anew
    public <R extends Record> R with(R root, Record value) {
        return (R) with(root, 0, value);
    }

    private Record with(Record owner, int depth, Record value) {
        if (depth == steps.size()) {
            return value;
        }
        RecordKind kind = RecordKind.of(owner);
        RecordField step = steps.get(depth);
        return kind.with(owner, step, with((Record) kind.get(owner, step), depth + 1, value));
    }

    /** Returns true if a level may be without it. */
    public boolean isOptional() {
        return !steps.isEmpty() && steps.get(steps.size() - 1).isNullable();
    }
}
