package nephele.editor.panel.model;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.UnaryOperator;
import nephele.editor.added.AddedRecord;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.FieldKind;
import nephele.editor.record.ListEdit;
import nephele.editor.record.RecordKind;
import nephele.editor.text.Words;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.level.appearance.SolidFaces;
import nephele.engine.math.Vec3;

/** The fields of the selected records, and the changes that an inspector makes; all return a new root record. */
public final class InspectorModel {
    /** The level itself, which is inspected if nothing is selected. */
    public static final List<EntityRef> ROOT = List.of(EntityRef.single(""));

    private final Entities entities;

    public InspectorModel(Entities entities) {
        this.entities = entities;
    }

    /** Returns the union of the fields of some records, in the order of the file. */
    public List<InspectorField> fields(Record root, List<EntityRef> refs) {
        List<Record> owners =
                refs.stream().flatMap(ref -> entities.find(root, ref).stream()).toList();
        return new FieldUnion(refs, entities).fields(owners);
    }

    /** Returns what is wrong with a value for a field. */
    public Optional<Words> problem(Record root, List<EntityRef> refs, InspectorField field, Object value) {
        boolean isTaken = field.isId()
                && !value.equals(field.value())
                && entities.find(root, new EntityRef(refs.get(0).section(), (String) value))
                        .isPresent();
        return isTaken
                ? Optional.of(PanelText.ID_TAKEN.with(value))
                : field.type().problem(value);
    }

    /** Returns the root with a field of some records changed, each from its own value. */
    public Record changed(Record root, Collection<EntityRef> refs, InspectorField field, UnaryOperator<Object> change) {
        return entities.changed(root, refs, owner -> field.path().changed(owner, change));
    }

    /** Returns the root with a value in a field of some records; the id also changes where it is referred to. */
    public Record set(Record root, List<EntityRef> refs, InspectorField field, Object value) {
        return field.isId()
                ? entities.renamed(root, refs.get(0), (String) value)
                : changed(root, refs, field, old -> value);
    }

    /** Returns the root with the default value in a field. */
    public Record reset(Record root, List<EntityRef> refs, InspectorField field) {
        return set(root, refs, field, field.type().defaultValue());
    }

    /** Returns the root with a value in a field that had none, and what the value needs. */
    public Record fresh(Record root, List<EntityRef> refs, InspectorField field) {
        return completed(root, set(root, refs, field, field.type().freshValue()));
    }

    private static Record completed(Record before, Record after) {
        return before instanceof Level old && after instanceof Level level ? AddedRecord.completed(old, level) : after;
    }

    /** Returns the root with another kind of record in a field; components of the same name and class stay. */
    public Record withKind(Record root, List<EntityRef> refs, InspectorField field, RecordKind kind) {
        return completed(root, changed(root, refs, field, old -> converted(old, kind)));
    }

    private static Object converted(Object old, RecordKind kind) {
        Record made = AddedRecord.at(kind, FieldType.NEW, Vec3.ZERO);
        if (!(old instanceof Record before)) {
            return made;
        }
        RecordKind oldKind = RecordKind.of(before);
        if (oldKind == kind) {
            return old;
        }
        Record result = made;
        for (var field : kind.fields()) {
            var same = oldKind.field(field.name())
                    .filter(other -> other.valueClass() == field.valueClass()
                            && Objects.equals(
                                    other.declaration().prototype(),
                                    field.declaration().prototype()))
                    .map(other -> oldKind.get(before, other));
            if (same.isPresent()) {
                result = kind.with(result, field, same.get());
            }
        }
        return result;
    }

    /** Returns the root with an entry at the end of a list, or with a key in a table. */
    public Record added(Record root, List<EntityRef> refs, InspectorField field, Object key) {
        FieldType type = FieldType.ofEntry(field.type().field());
        Record after = changed(root, refs, field, old -> {
            if (field.type().kind() == FieldKind.LIST) {
                List<Object> entries = new ArrayList<>(old == null ? List.of() : (List<?>) old);
                entries.add(entries.isEmpty() ? type.freshValue() : entries.get(entries.size() - 1));
                return List.copyOf(entries);
            }
            Map<Object, Object> entries = new LinkedHashMap<>(old == null ? Map.of() : (Map<?, ?>) old);
            entries.putIfAbsent(key, type.freshValue());
            return Collections.unmodifiableMap(entries);
        });
        return completed(root, after);
    }

    /** Returns the root without an entry of a table. */
    public Record removed(Record root, List<EntityRef> refs, InspectorField entry) {
        Object key = entry.path().last().entry();
        RecordPath owner = entry.path().owner();
        UnaryOperator<Object> change = old -> {
            if (old instanceof Map<?, ?> table) {
                Map<Object, Object> left = new LinkedHashMap<>(table);
                left.remove(key);
                return Collections.unmodifiableMap(left);
            }
            return old;
        };
        return entities.changed(root, refs, record -> owner.changed(record, change));
    }

    /** Returns the root with an edit of the list that has an entry. */
    public Record listEdited(Record root, List<EntityRef> refs, InspectorField entry, ListEdit edit) {
        RecordPath owner = entry.path().owner();
        return entities.changed(
                root, refs, record -> owner.changed(record, old -> old instanceof List<?> list ? edit.on(list) : old));
    }

    /** Returns the length of the list that has an entry. */
    public int length(Record root, List<EntityRef> refs, InspectorField entry) {
        return refs.stream()
                .flatMap(ref -> entities.find(root, ref).stream())
                .map(owner -> entry.path().owner().get(owner))
                .mapToInt(list -> list instanceof List<?> entries ? entries.size() : 0)
                .max()
                .orElse(0);
    }

    /** Returns the ids that a reference may have. */
    public List<String> ids(Record root, String section) {
        return entities.list(section).stream()
                .flatMap(list -> list.entities(root).stream())
                .map(RecordKind::id)
                .toList();
    }

    /** Returns the keys that a table has not; of a table with texts as keys, only those of a solid's faces are known. */
    public List<Object> missingKeys(Record root, List<EntityRef> refs, InspectorField table) {
        Optional<Record> owner = entities.find(root, refs.get(0));
        if (hasTextKeys(table) && owner.isPresent() && owner.get() instanceof Solid solid) {
            List<Object> faces = new ArrayList<>(SolidFaces.names(solid));
            table.values().forEach(value -> faces.removeAll(((Map<?, ?>) value).keySet()));
            return faces;
        }
        var type = (java.lang.reflect.ParameterizedType)
                table.type().field().written().type();
        Class<?> keyClass = (Class<?>) type.getActualTypeArguments()[0];
        List<Object> keys = new ArrayList<>();
        if (keyClass.isEnum()) {
            keys.addAll(List.of(keyClass.getEnumConstants()));
            new LinkedHashSet<>(table.values()).forEach(value -> {
                if (value instanceof Map<?, ?> present && !table.isMixed()) {
                    keys.removeAll(present.keySet());
                }
            });
        }
        return keys;
    }

    /** Returns true if the keys of a table are any texts. */
    public static boolean hasTextKeys(InspectorField table) {
        var type = (java.lang.reflect.ParameterizedType)
                table.type().field().written().type();
        return type.getActualTypeArguments()[0] == String.class;
    }
}
