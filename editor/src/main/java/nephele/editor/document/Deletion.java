package nephele.editor.document;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.EntitySection;
import nephele.editor.record.RecordField;
import nephele.editor.record.RecordKind;
import nephele.editor.record.SingleSection;
import nephele.engine.level.Level;
import nephele.engine.level.PortalSpec;

/** The deletion of entities, some of which others may refer to, such as a material, a camera or a linked portal. */
public final class Deletion {
    private final Snapshot before;
    private final Set<EntityRef> gone;
    /** The deleted ids by the section that references name. */
    private final Map<String, Set<String>> ids = new HashMap<>();

    public Deletion(Snapshot before, Collection<EntityRef> gone) {
        this.before = before;
        this.gone = new LinkedHashSet<>(gone);
        gone.forEach(ref ->
                ids.computeIfAbsent(ref.section(), any -> new HashSet<>()).add(ref.id()));
    }

    /** Returns the entities that stay and refer to a deleted one. */
    public List<EntityRef> users() {
        List<EntityRef> users = new ArrayList<>();
        for (EntitySection section : Entities.LEVEL.lists()) {
            for (Record entity : section.entities(before.level())) {
                addUser(users, new EntityRef(section.path(), RecordKind.id(entity)), entity);
            }
        }
        for (SingleSection single : Entities.LEVEL.singles()) {
            // The level and the environment hold the lists, whose entities are users themselves.
            boolean isOwner = Entities.LEVEL.lists().stream()
                    .anyMatch(list -> single.path().isEmpty() || list.path().startsWith(single.path() + "."));
            if (!isOwner && single.get(before.level()) != null) {
                addUser(users, EntityRef.single(single.path()), single.get(before.level()));
            }
        }
        return List.copyOf(users);
    }

    private void addUser(List<EntityRef> users, EntityRef ref, Record entity) {
        boolean isUser = !gone.contains(ref) && replaced(entity, Optional.of("")) != entity;
        if (isUser) {
            users.add(ref);
        }
    }

    /** Returns the ids that can stand for what is deleted; those of all sections that it is of. */
    public Set<String> substitutes() {
        Set<String> found = new LinkedHashSet<>();
        ids.keySet().forEach(section -> found.addAll(left(before.level(), section)));
        return found;
    }

    private List<String> left(Level level, String section) {
        return Entities.LEVEL.list(section).stream()
                .flatMap(list -> list.entities(level).stream())
                .map(RecordKind::id)
                .filter(id -> !ids.get(section).contains(id))
                .toList();
    }

    /**
     * Returns the state after the deletion.
     *
     * @param substitute what references name instead; if empty, optional ones are absent, a portal leads to itself, and
     *     others name the first entity that is left
     */
    public Snapshot after(Optional<String> substitute) {
        Level rid = Entities.LEVEL.changed(before.level(), users(), entity -> replaced(entity, substitute));
        return before.with(rid).without(gone);
    }

    private Record replaced(Record entity, Optional<String> substitute) {
        return RecordKind.mapped(entity, (field, value) -> {
            Set<String> deleted = ids.getOrDefault(field.declaration().refersTo(), Set.of());
            return value instanceof String id && deleted.contains(id)
                    ? substitute.orElseGet(() -> absent(entity, field, id))
                    : value;
        });
    }

    private String absent(Record owner, RecordField field, String id) {
        if (!field.isRequired()) {
            return null;
        }
        String section = field.declaration().refersTo();
        return owner instanceof PortalSpec portal
                ? portal.id()
                : left(before.level(), section).stream().findFirst().orElse(id);
    }
}
