package nephele.editor.panel.model;

import java.util.List;
import java.util.Set;
import nephele.editor.record.EntityRef;
import nephele.engine.level.EditorNotes;

/** Groups, hidden and locked entities of a level, for quick questions; entities are named {@code section/id}. */
public record EntityStatus(List<EditorNotes.Group> groups, Set<String> hidden, Set<String> locked) {
    /** The status of a level in which nothing is grouped, hidden or locked. */
    public static final EntityStatus NONE = of(EditorNotes.NONE);

    /** Returns the status that a level's notes give. */
    public static EntityStatus of(EditorNotes notes) {
        return new EntityStatus(notes.groups(), Set.copyOf(notes.hidden()), Set.copyOf(notes.locked()));
    }

    /** Returns true if the editor does not show an entity. */
    public boolean isHidden(EntityRef ref) {
        return hidden.contains(ref.text());
    }

    /** Returns true if views do not select an entity. */
    public boolean isLocked(EntityRef ref) {
        return locked.contains(ref.text());
    }
}
