package nephele.editor.record;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import nephele.engine.level.EditorNotes;
import nephele.engine.level.Level;

/**
 * The sections of a level, found from its record class: lists of entities, and single records. It finds, adds, replaces,
 * removes and renames entities; all changes return a new root record.
 */
public final class Entities {
    /** The entities of levels of this version. */
    public static final Entities LEVEL = of(Level.class);

    private final List<EntitySection> lists = new ArrayList<>();
    private final List<SingleSection> singles = new ArrayList<>();

    private Entities(Class<? extends Record> root) {
        singles.add(new SingleSection("", List.of(), List.of(RecordKind.of(root))));
        explore(RecordKind.of(root), "", List.of());
    }

    /** Returns the entities of a kind of root record. */
    public static Entities of(Class<? extends Record> root) {
        return new Entities(root);
    }

    private void explore(RecordKind owner, String prefix, List<RecordField> steps) {
        for (RecordField field : owner.fields()) {
            String path = prefix + field.name();
            List<RecordKind> kinds =
                    field.recordClasses().stream().map(RecordKind::of).toList();
            if (kinds.isEmpty() || field.valueClass() == EditorNotes.class) {
                continue;
            }
            if (field.kind() == FieldKind.LIST && kinds.stream().allMatch(Entities::hasId)) {
                lists.add(new EntitySection(path, steps, field, kinds));
            } else if (field.kind() == FieldKind.RECORD || field.kind() == FieldKind.VARIANT) {
                List<RecordField> deeper = new ArrayList<>(steps);
                deeper.add(field);
                singles.add(new SingleSection(path, List.copyOf(deeper), kinds));
                if (kinds.size() == 1 && !field.isNullable()) {
                    explore(kinds.get(0), path + ".", List.copyOf(deeper));
                }
            }
        }
    }

    private static boolean hasId(RecordKind kind) {
        return kind.fields().stream().anyMatch(RecordField::isId);
    }

    /** Returns the lists of entities, in the order of the file. */
    public List<EntitySection> lists() {
        return List.copyOf(lists);
    }

    /** Returns the single records, the level itself first. */
    public List<SingleSection> singles() {
        return List.copyOf(singles);
    }

    public Optional<EntitySection> list(String path) {
        return lists.stream().filter(section -> section.path().equals(path)).findFirst();
    }

    public Optional<SingleSection> single(String path) {
        return singles.stream().filter(section -> section.path().equals(path)).findFirst();
    }

    /** Returns every entity and single record that the level has, in the order of the file; not the level itself. */
    public List<EntityRef> all(Record root) {
        List<EntityRef> all = new ArrayList<>();
        for (SingleSection single : singles) {
            if (!single.path().isEmpty() && single.get(root) != null) {
                all.add(EntityRef.single(single.path()));
            }
        }
        for (EntitySection section : lists) {
            section.entities(root).forEach(entity -> all.add(new EntityRef(section.path(), RecordKind.id(entity))));
        }
        return all;
    }

    /** Returns the record of an entity; empty if the level has none of that name. */
    public Optional<Record> find(Record root, EntityRef ref) {
        if (ref.id().isEmpty()) {
            return single(ref.section()).map(section -> section.get(root));
        }
        return list(ref.section()).flatMap(section -> section.entities(root).stream()
                .filter(entity -> RecordKind.id(entity).equals(ref.id()))
                .findFirst());
    }

    /** Returns the level with the records of some entities changed; unknown names are ignored. */
    public <R extends Record> R changed(R root, Collection<EntityRef> refs, UnaryOperator<Record> change) {
        R result = root;
        Set<EntityRef> wanted = new HashSet<>(refs);
        for (SingleSection single : singles) {
            if (wanted.contains(EntityRef.single(single.path())) && single.get(result) != null) {
                result = single.with(result, change.apply(single.get(result)));
            }
        }
        for (EntitySection section : lists) {
            result = changedList(result, section, wanted, change);
        }
        return result;
    }

    private static <R extends Record> R changedList(
            R root, EntitySection section, Set<EntityRef> wanted, UnaryOperator<Record> change) {
        if (wanted.stream().noneMatch(ref -> ref.section().equals(section.path()))) {
            return root;
        }
        boolean differs = false;
        List<Record> entities = new ArrayList<>();
        for (Record entity : section.entities(root)) {
            boolean isMeant = wanted.contains(new EntityRef(section.path(), RecordKind.id(entity)));
            Record after = isMeant ? change.apply(entity) : entity;
            differs |= after != entity;
            entities.add(after);
        }
        return differs ? section.with(root, entities) : root;
    }

    /** Returns the level with an entity at the end of its section, or as its single record. */
    public <R extends Record> R added(R root, String sectionPath, Record entity) {
        Optional<EntitySection> list = list(sectionPath);
        if (list.isPresent()) {
            List<Record> entities = new ArrayList<>(list.get().entities(root));
            entities.add(entity);
            return list.get().with(root, entities);
        }
        return single(sectionPath).orElseThrow().with(root, entity);
    }

    /** Returns the level with one entity replaced by others in its place. */
    public <R extends Record> R replaced(R root, EntityRef ref, List<? extends Record> others) {
        EntitySection section = list(ref.section()).orElseThrow();
        List<Record> entities = new ArrayList<>();
        for (Record entity : section.entities(root)) {
            if (RecordKind.id(entity).equals(ref.id())) {
                entities.addAll(others);
            } else {
                entities.add(entity);
            }
        }
        return section.with(root, entities);
    }

    /** Returns the level without some entities; single records that must exist stay. */
    public <R extends Record> R without(R root, Collection<EntityRef> refs) {
        R result = root;
        Set<EntityRef> unwanted = new HashSet<>(refs);
        for (SingleSection single : singles) {
            if (single.isOptional()
                    && unwanted.contains(EntityRef.single(single.path()))
                    && single.get(result) != null) {
                result = single.with(result, null);
            }
        }
        for (EntitySection section : lists) {
            List<Record> left = section.entities(result).stream()
                    .filter(entity -> !unwanted.contains(new EntityRef(section.path(), RecordKind.id(entity))))
                    .toList();
            if (left.size() < section.entities(result).size()) {
                result = section.with(result, left);
            }
        }
        return result;
    }

    /** Returns an id that no entity of the section has: the wish itself, or with the first free number. */
    public String freshId(Record root, String sectionPath, String wish) {
        return freshId(root, sectionPath, wish, Set.of());
    }

    /** Returns an id that neither an entity of the section has nor {@code taken} contains. */
    public String freshId(Record root, String sectionPath, String wish, Set<String> taken) {
        Set<String> used = new HashSet<>(taken);
        list(sectionPath)
                .ifPresent(section -> section.entities(root).forEach(entity -> used.add(RecordKind.id(entity))));
        if (!used.contains(wish)) {
            return wish;
        }
        String stem = wish.replaceFirst("-\\d+$", "");
        int number = 2;
        while (used.contains(stem + "-" + number)) {
            number++;
        }
        return stem + "-" + number;
    }

    /** Returns the level with another id of an entity and of all references to it. */
    public <R extends Record> R renamed(R root, EntityRef ref, String newId) {
        R result = changed(root, List.of(ref), entity -> withId(entity, newId));
        return withReferences(result, ref.section(), id -> id.equals(ref.id()) ? newId : id);
    }

    /** Returns a record with another id. */
    public static <R extends Record> R withId(R entity, String id) {
        RecordKind kind = RecordKind.of(entity);
        RecordField field =
                kind.fields().stream().filter(RecordField::isId).findFirst().orElseThrow();
        return kind.with(entity, field, id);
    }

    /** Returns the entities that refer to an entity. */
    public Set<EntityRef> usages(Record root, EntityRef ref) {
        Set<EntityRef> users = new LinkedHashSet<>();
        for (EntityRef candidate : all(root)) {
            Record entity = find(root, candidate).orElseThrow();
            boolean isOwner = single(candidate.section()).isPresent()
                    && lists.stream().anyMatch(list -> list.path().startsWith(candidate.section() + "."));
            if (!isOwner && references(entity, ref.section()).contains(ref.id())) {
                users.add(candidate);
            }
        }
        return users;
    }

    /** Returns the ids of a section's entities that a record refers to, in a set of the caller's. */
    public static Set<String> references(Record entity, String section) {
        Set<String> found = new TreeSet<>();
        RecordKind.mapped(entity, (field, value) -> {
            if (value != null && field.declaration().refersTo().equals(section)) {
                found.add((String) value);
            }
            return value;
        });
        return found;
    }

    /** Returns a record with other references to a section's entities; {@code null} for an id drops it. */
    public static <R extends Record> R withReferences(R entity, String section, UnaryOperator<String> change) {
        return RecordKind.mapped(
                entity,
                (field, value) -> field.declaration().refersTo().equals(section) && value != null
                        ? change.apply((String) value)
                        : value);
    }
}
