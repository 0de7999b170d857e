package nephele.editor.panel.model;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.editor.panel.model.OutlinerRow.Kind;
import nephele.editor.panel.model.OutlinerRow.State;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.EntitySection;
import nephele.editor.record.RecordKind;
import nephele.editor.record.SingleSection;
import nephele.engine.level.EditorNotes;

/** The lines of the outliner: groups, single records, and a section for each list of entities that the structure has. */
public final class OutlinerModel {
    /** The rows of a section and their inputs; equal inputs give equal rows. */
    private record Cached(
            List<Record> entities, EntityStatus status, EntityQuery query, boolean isOpen, List<OutlinerRow> rows) {
        boolean isOf(List<Record> others, EntityStatus now, EntityQuery asked, boolean open) {
            return entities == others && isOpen == open && status.equals(now) && query.equals(asked);
        }
    }

    private final Entities entities;
    private final Set<String> folded = new HashSet<>();
    private final Map<String, Cached> cache = new HashMap<>();

    public OutlinerModel(Entities entities) {
        this.entities = entities;
    }

    /** Folds or unfolds the line with a key. */
    public void toggleFold(String key) {
        if (!folded.remove(key)) {
            folded.add(key);
        }
    }

    /** Returns the lines; with a query, only those of matching entities and no empty sections. */
    public List<OutlinerRow> rows(Record root, EntityStatus status, EntityQuery query) {
        List<OutlinerRow> rows = new ArrayList<>();
        addGroups(rows, root, status, query);
        for (SingleSection single : entities.singles()) {
            if (!single.path().isEmpty() && single.get(root) != null) {
                EntityRef ref = EntityRef.single(single.path());
                if (query.matches(ref, single.get(root), status)) {
                    rows.add(entity(single.path(), 0, single.path().replace(".", " › "), ref, status));
                }
            }
        }
        for (EntitySection section : entities.lists()) {
            rows.addAll(section(section, root, status, query));
        }
        return rows;
    }

    private List<OutlinerRow> section(EntitySection section, Record root, EntityStatus status, EntityQuery query) {
        List<Record> all = section.entities(root);
        boolean isOpen = !folded.contains(section.path());
        Cached cached = cache.get(section.path());
        if (cached == null || !cached.isOf(all, status, query, isOpen)) {
            cached = new Cached(all, status, query, isOpen, section(section, all, status, query, isOpen));
            cache.put(section.path(), cached);
        }
        return cached.rows;
    }

    private static List<OutlinerRow> section(
            EntitySection section, List<Record> all, EntityStatus status, EntityQuery query, boolean isOpen) {
        List<OutlinerRow> rows = new ArrayList<>();
        List<EntityRef> members = new ArrayList<>();
        for (Record entity : all) {
            EntityRef ref = new EntityRef(section.path(), RecordKind.id(entity));
            if (query.matches(ref, entity, status)) {
                members.add(ref);
                rows.add(entity(ref.text(), 1, ref.id(), ref, status));
            }
        }
        if (members.isEmpty() && !query.terms().isEmpty()) {
            return List.of();
        }
        var head = new OutlinerRow(
                Kind.SECTION, section.path(), 0, section.title(), members, state(isOpen, members, status));
        if (!isOpen) {
            return List.of(head);
        }
        rows.add(0, head);
        return rows;
    }

    private void addGroups(List<OutlinerRow> rows, Record root, EntityStatus status, EntityQuery query) {
        if (status.groups().isEmpty() || !query.terms().isEmpty()) {
            return;
        }
        boolean isOpen = !folded.contains("#groups");
        rows.add(new OutlinerRow(Kind.GROUPS, "#groups", 0, "", List.of(), new State(isOpen, false, false)));
        if (!isOpen) {
            return;
        }
        Set<EntityRef> present = new HashSet<>(entities.all(root));
        for (EditorNotes.Group group : status.groups()) {
            String key = "#groups/" + group.id();
            List<EntityRef> members = group.members().stream()
                    .map(EntityRef::of)
                    .filter(present::contains)
                    .toList();
            boolean isGroupOpen = folded.contains(key);
            rows.add(new OutlinerRow(Kind.GROUP, key, 1, group.id(), members, state(isGroupOpen, members, status)));
            if (isGroupOpen) {
                members.forEach(ref -> rows.add(entity(key + "/" + ref.text(), 2, ref.shortName(), ref, status)));
            }
        }
    }

    private static OutlinerRow entity(String key, int depth, String title, EntityRef ref, EntityStatus status) {
        List<EntityRef> members = List.of(ref);
        return new OutlinerRow(Kind.ENTITY, key, depth, title, members, state(false, members, status));
    }

    private static State state(boolean isOpen, List<EntityRef> members, EntityStatus status) {
        boolean isAny = !members.isEmpty();
        return new State(
                isOpen,
                isAny && members.stream().allMatch(status::isHidden),
                isAny && members.stream().allMatch(status::isLocked));
    }
}
