package nephele.editor.panel.model;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
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

    /** Returns the notes with entities hidden, or all of them shown if they were hidden. */
    public static EditorNotes hiddenToggled(EditorNotes notes, Collection<EntityRef> refs) {
        return new EditorNotes(notes.groups(), toggled(notes.hidden(), refs), notes.locked(), notes.ignoredProblems());
    }

    /** Returns the notes with entities locked, or all of them unlocked if they were locked. */
    public static EditorNotes lockedToggled(EditorNotes notes, Collection<EntityRef> refs) {
        return new EditorNotes(notes.groups(), notes.hidden(), toggled(notes.locked(), refs), notes.ignoredProblems());
    }

    private static List<String> toggled(List<String> names, Collection<EntityRef> refs) {
        Set<String> result = new LinkedHashSet<>(names);
        List<String> meant = refs.stream().map(EntityRef::text).toList();
        if (!result.containsAll(meant)) {
            result.addAll(meant);
        } else {
            meant.forEach(result::remove);
        }
        return List.copyOf(new ArrayList<>(result));
    }
}
