package nephele.editor.record;

import java.util.List;

/**
 * A list of entities of a level.
 *
 * @param path such as {@code solids} or {@code environment.clouds}
 * @param owners components from the level down to the record that has the list
 * @param list the component that is the list
 * @param kinds the classes of the entities
 */
public record EntitySection(String path, List<RecordField> owners, RecordField list, List<RecordKind> kinds) {
    /** Returns the entities in the order of the file. */
    @SuppressWarnings("unchecked") // a section's list has records only
    public List<Record> entities(Record root) {
        Record owner = root;
        for (RecordField step : owners) {
            owner = (Record) RecordKind.of(owner).get(owner, step);
        }
        return (List<Record>) RecordKind.of(owner).get(owner, list);
    }

    /** Returns the level with other entities. */
    public <R extends Record> R with(R root, List<? extends Record> entities) {
        return with(root, 0, List.copyOf(entities));
    }

    private <R extends Record> R with(R owner, int depth, List<Record> entities) {
        RecordKind kind = RecordKind.of(owner);
        if (depth == owners.size()) {
            return kind.with(owner, list, entities);
        }
        RecordField step = owners.get(depth);
        return kind.with(owner, step, with((Record) kind.get(owner, step), depth + 1, entities));
    }

    /** Returns the last word of the path, such as {@code clouds}. */
    public String title() {
        return list.name();
    }
}
