package nephele.editor.document;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.RecordKind;
import nephele.engine.level.Level;

/** A state of the document: the level and what is selected in it. Immutable; snapshots share unchanged parts. */
public record Snapshot(Level level, Selection selection) {
    public Snapshot with(Level other) {
        return new Snapshot(other, selection);
    }

    public Snapshot with(Selection other) {
        return new Snapshot(level, other);
    }

    /** Returns the state without some entities, also in the notes and the selection. */
    public Snapshot without(Collection<EntityRef> removed) {
        Level left = Entities.LEVEL.without(level, removed);
        return new Snapshot(NoteEdits.without(left, removed), selection.only(ref -> !removed.contains(ref)));
    }

    /**
     * Returns the state with entities cut into pieces, merged or removed: the pieces stand where each source stood, are
     * hidden, locked and grouped as it was, and are selected if it was.
     */
    public Snapshot replaced(Map<EntityRef, ? extends List<? extends Record>> pieces) {
        Level changed = level;
        Map<EntityRef, List<EntityRef>> names = new LinkedHashMap<>();
        for (Map.Entry<EntityRef, ? extends List<? extends Record>> source : pieces.entrySet()) {
            EntityRef ref = source.getKey();
            changed = Entities.LEVEL.replaced(changed, ref, source.getValue());
            names.put(
                    ref,
                    source.getValue().stream()
                            .map(piece -> new EntityRef(ref.section(), RecordKind.id(piece)))
                            .toList());
        }
        List<EntityRef> selected = selection.entities().stream()
                .flatMap(ref -> names.getOrDefault(ref, List.of(ref)).stream())
                .toList();
        return new Snapshot(NoteEdits.replaced(changed, names), new Selection(selected, selection.faces()));
    }

    /** Returns the state with another id of an entity, also in references, notes and the selection. */
    public Snapshot renamed(EntityRef before, String newId) {
        EntityRef after = new EntityRef(before.section(), newId);
        Level renamed = Entities.LEVEL.renamed(level, before, newId);
        return new Snapshot(NoteEdits.renamed(renamed, before, after), selection.renamed(before, after));
    }
}
