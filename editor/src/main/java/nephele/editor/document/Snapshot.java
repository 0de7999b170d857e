package nephele.editor.document;

import java.util.Collection;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
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
        Level left = (Level) Entities.LEVEL.without(level, removed);
        return new Snapshot(Notes.without(left, removed), selection.only(ref -> !removed.contains(ref)));
    }

    /** Returns the state with another id of an entity, also in references, notes and the selection. */
    public Snapshot renamed(EntityRef before, String newId) {
        EntityRef after = new EntityRef(before.section(), newId);
        Level renamed = (Level) Entities.LEVEL.renamed(level, before, newId);
        return new Snapshot(Notes.renamed(renamed, before, after), selection.renamed(before, after));
    }
}
