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
import nephele.editor.text.ChoiceWord;
import nephele.engine.level.EditorNotes;

/** Lists the fields that any of some records has; lists of entities are left out, since they have selections of their own. */
final class FieldUnion {
    /** Fields of the same name and class count as one, whatever kinds of records they are in. */
    private record Identity(String name, FieldKind kind, Class<?> valueClass) {}

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
        Map<Identity, RecordField> union = new LinkedHashMap<>();
        Set<RecordKind> kinds = new LinkedHashSet<>();
        owners.forEach(owner -> kinds.add(RecordKind.of(owner)));
        for (RecordKind kind : kinds) {
            for (RecordField field : kind.fields()) {
                union.putIfAbsent(new Identity(field.name(), field.kind(), field.valueClass()), field);
            }
        }
        for (RecordField field : union.values()) {
            String path = section == null ? null : section.isEmpty() ? field.name() : section + "." + field.name();
            if (isShown(field, path)) {
                component(prefix.component(field.name()), path, depth, valuesOf(owners, field));
            }
        }
    }

    private boolean isShown(RecordField field, String section) {
        boolean isEntities = section != null && entities.list(section).isPresent();
        boolean isCommonId = field.isId() && refs.size() > 1;
        return !isEntities && !isCommonId && field.valueClass() != EditorNotes.class;
    }

    private record Values(RecordField field, List<Object> all) {}

    private static Values valuesOf(List<Record> owners, RecordField field) {
        List<Object> all = new ArrayList<>();
        for (Record owner : owners) {
            RecordKind kind = RecordKind.of(owner);
            kind.field(field.name())
                    .filter(own -> own.kind() == field.kind() && own.valueClass() == field.valueClass())
                    .ifPresent(own -> all.add(kind.get(owner, own)));
        }
        return new Values(field, all);
    }

    private void component(RecordPath path, String section, int depth, Values values) {
        FieldType type = FieldType.of(values.field);
        found.add(new InspectorField(path, type, depth, values.field.title(), distinct(values.all), false));
        inside(path, section, depth + 1, values);
    }

    private static List<Object> distinct(List<Object> all) {
        return new ArrayList<>(new LinkedHashSet<>(all));
    }

    private void inside(RecordPath path, String section, int depth, Values values) {
        List<Object> present = values.all.stream().filter(Objects::nonNull).toList();
        switch (values.field.kind()) {
            case RECORD, VARIANT -> records(path, section, depth, records(present));
            case LIST -> list(path, depth, new Values(values.field, present));
            case TABLE -> table(path, depth, new Values(values.field, present));
            default -> {}
        }
    }

    private static List<Record> records(Collection<?> values) {
        return values.stream().map(Record.class::cast).toList();
    }

    private void list(RecordPath path, int depth, Values lists) {
        Set<Integer> sizes = new TreeSet<>();
        lists.all.forEach(list -> sizes.add(((List<?>) list).size()));
        if (sizes.size() != 1) {
            return;
        }
        for (int i = 0; i < sizes.iterator().next(); i++) {
            int index = i;
            List<Object> entries = new ArrayList<>();
            lists.all.forEach(list -> entries.add(((List<?>) list).get(index)));
            entry(path.entry(index), depth, String.valueOf(index + 1), new Values(lists.field, entries));
        }
    }

    private void table(RecordPath path, int depth, Values tables) {
        Set<Set<?>> keys = new LinkedHashSet<>();
        tables.all.forEach(table -> keys.add(((Map<?, ?>) table).keySet()));
        if (keys.size() != 1) {
            return;
        }
        for (Object key : keys.iterator().next()) {
            List<Object> entries = new ArrayList<>();
            tables.all.forEach(table -> entries.add(((Map<?, ?>) table).get(key)));
            entry(path.entry(key), depth, ChoiceWord.of(key), new Values(tables.field, entries));
        }
    }

    private void entry(RecordPath path, int depth, String title, Values entries) {
        FieldType type = FieldType.ofEntry(entries.field);
        found.add(new InspectorField(path, type, depth, title, distinct(entries.all), true));
        if (type.kind() == FieldKind.RECORD || type.kind() == FieldKind.VARIANT) {
            records(path, null, depth + 1, records(entries.all));
        }
    }
}
