package nephele.editor.panel.model;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.FieldKind;
import nephele.editor.record.RecordField;
import nephele.editor.record.RecordKind;
import nephele.editor.text.FieldWords;
import nephele.engine.level.EditorNotes;

/** Lists the fields that any of some records has; lists of entities are left out, since they have selections of their own. */
final class FieldUnion {
    private final List<EntityRef> refs;
    private final Entities entities;
    private final List<InspectorField> found = new ArrayList<>();

    FieldUnion(List<EntityRef> refs, Entities entities) {
        this.refs = refs;
        this.entities = entities;
    }

    List<InspectorField> fields(List<Record> owners) {
        String prefix =
                refs.size() == 1 && refs.get(0).id().isEmpty() ? refs.get(0).section() : null;
        records(RecordPath.SELF, prefix, 0, owners);
        return List.copyOf(found);
    }

    /** @param section path of a single record, {@code null} inside an entity of a list */
    private void records(RecordPath prefix, String section, int depth, List<Record> owners) {
        // Fields of the same name and class count as one, whatever kinds of records they are in.
        Map<List<Object>, RecordField> union = new LinkedHashMap<>();
        Set<RecordKind> kinds = new LinkedHashSet<>();
        owners.forEach(owner -> kinds.add(RecordKind.of(owner)));
        for (RecordKind kind : kinds) {
            for (RecordField field : kind.fields()) {
                union.putIfAbsent(List.of(field.name(), field.kind(), field.valueClass()), field);
            }
        }
        for (RecordField field : union.values()) {
            String path = section == null ? null : section.isEmpty() ? field.name() : section + "." + field.name();
            if (isListed(field, path)) {
                component(prefix.component(field.name()), path, depth, field, values(owners, field));
            }
        }
    }

    private boolean isListed(RecordField field, String section) {
        boolean isEntities = section != null && entities.list(section).isPresent();
        boolean isCommonId = field.isId() && refs.size() > 1;
        return !isEntities && !isCommonId && field.valueClass() != EditorNotes.class;
    }

    private static List<Object> values(List<Record> owners, RecordField field) {
        List<Object> all = new ArrayList<>();
        for (Record owner : owners) {
            RecordKind kind = RecordKind.of(owner);
            kind.field(field.name())
                    .filter(own -> own.kind() == field.kind() && own.valueClass() == field.valueClass())
                    .ifPresent(own -> all.add(kind.get(owner, own)));
        }
        return all;
    }

    private void component(RecordPath path, String section, int depth, RecordField field, List<Object> values) {
        found.add(new InspectorField(path, FieldType.of(field), depth, field.title(), distinct(values), false));
        List<Object> present = values.stream().filter(Objects::nonNull).toList();
        switch (field.kind()) {
            case RECORD, VARIANT -> records(path, section, depth + 1, records(present));
            case LIST -> list(path, depth + 1, field, present);
            case TABLE -> table(path, depth + 1, field, present);
            default -> {}
        }
    }

    private static List<Object> distinct(List<Object> all) {
        return new ArrayList<>(new LinkedHashSet<>(all));
    }

    private static List<Record> records(Collection<?> values) {
        return values.stream().map(Record.class::cast).toList();
    }

    private void list(RecordPath path, int depth, RecordField field, List<Object> lists) {
        Set<Integer> sizes = new TreeSet<>();
        lists.forEach(list -> sizes.add(((List<?>) list).size()));
        if (sizes.size() != 1) {
            return;
        }
        for (int i = 0; i < sizes.iterator().next(); i++) {
            int index = i;
            List<Object> entries = new ArrayList<>();
            lists.forEach(list -> entries.add(((List<?>) list).get(index)));
            entry(path.entry(index), depth, String.valueOf(index + 1), field, entries);
        }
    }

    private void table(RecordPath path, int depth, RecordField field, List<Object> tables) {
        Set<Set<?>> keys = new LinkedHashSet<>();
        tables.forEach(table -> keys.add(((Map<?, ?>) table).keySet()));
        if (keys.size() != 1) {
            return;
        }
        for (Object key : keys.iterator().next()) {
            List<Object> entries = new ArrayList<>();
            tables.forEach(table -> entries.add(((Map<?, ?>) table).get(key)));
            entry(path.entry(key), depth, FieldWords.choiceInFiles(key), field, entries);
        }
    }

    private void entry(RecordPath path, int depth, String title, RecordField field, List<Object> entries) {
        FieldType type = FieldType.ofEntry(field);
        found.add(new InspectorField(path, type, depth, title, distinct(entries), true));
        if (type.kind() == FieldKind.RECORD || type.kind() == FieldKind.VARIANT) {
            records(path, null, depth + 1, records(entries));
        }
    }
}
