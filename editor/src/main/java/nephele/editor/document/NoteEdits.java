package nephele.editor.document;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import nephele.editor.record.EntityRef;
import nephele.editor.text.Words;
import nephele.engine.level.EditorNotes;
import nephele.engine.level.EditorNotes.Group;
import nephele.engine.level.Level;

/** Changes of the editor's notes of a level: hiding, locking, grouping, and names that no longer exist. */
public final class NoteEdits {
    /** Why a locked entity stays as it is; with its name. */
    public static final Words LOCKED = Words.of(
            "%s is locked: unlock it first",
            "%s está bloqueado: desbloqueie antes", "%s está bloqueado: desbloqueia primeiro");

    private NoteEdits() {}

    /** Returns the level with entities hidden. */
    public static Level hidden(Level level, Collection<EntityRef> refs) {
        return withHidden(level, plus(level.editor().hidden(), refs));
    }

    /** Returns the level with entities hidden, or all of them shown if they were hidden. */
    public static Level hiddenToggled(Level level, Collection<EntityRef> refs) {
        return withHidden(level, toggled(level.editor().hidden(), refs));
    }

    /** Returns the level with entities locked. */
    public static Level locked(Level level, Collection<EntityRef> refs) {
        return withLocked(level, plus(level.editor().locked(), refs));
    }

    /** Returns the level with entities locked, or all of them unlocked if they were locked. */
    public static Level lockedToggled(Level level, Collection<EntityRef> refs) {
        return withLocked(level, toggled(level.editor().locked(), refs));
    }

    /** Returns the level with nothing hidden. */
    public static Level allVisible(Level level) {
        return level.editor().hidden().isEmpty() ? level : withHidden(level, List.of());
    }

    /** Returns the level with nothing locked. */
    public static Level allUnlocked(Level level) {
        return level.editor().locked().isEmpty() ? level : withLocked(level, List.of());
    }

    /** Returns the level with a new group of entities, which leave their former groups; the same group is no new one. */
    public static Level grouped(Level level, String id, Collection<EntityRef> refs) {
        Set<String> members = refs.stream().map(EntityRef::text).collect(Collectors.toSet());
        if (level.editor().groups().stream()
                .anyMatch(group -> Set.copyOf(group.members()).equals(members))) {
            return level;
        }
        List<Group> groups = new ArrayList<>(ungrouped(level, refs).editor().groups());
        groups.add(new Group(id, refs.stream().map(EntityRef::text).toList()));
        return withGroups(level, groups);
    }

    /** Returns the entities that may change: those that are not locked. */
    public static List<EntityRef> unlocked(Level level, Collection<EntityRef> refs) {
        Set<String> locked = Set.copyOf(level.editor().locked());
        return refs.stream().filter(ref -> !locked.contains(ref.text())).toList();
    }

    /** Returns the entities whose shape and look may change: those that are neither locked nor hidden. */
    public static List<EntityRef> free(Level level, Collection<EntityRef> refs) {
        Set<String> hidden = Set.copyOf(level.editor().hidden());
        return unlocked(level, refs).stream()
                .filter(ref -> !hidden.contains(ref.text()))
                .toList();
    }

    /** Returns the level whose notes name pieces where they named what was cut, hidden, locked and grouped as it was. */
    public static Level replaced(Level level, Map<EntityRef, List<EntityRef>> pieces) {
        Map<String, List<String>> names = new HashMap<>();
        pieces.forEach((ref, made) ->
                names.put(ref.text(), made.stream().map(EntityRef::text).toList()));
        return mapped(level, name -> names.getOrDefault(name, List.of(name)));
    }

    /** Returns the level without these entities in groups; a group with fewer than two members ends. */
    public static Level ungrouped(Level level, Collection<EntityRef> refs) {
        Set<String> leaving = refs.stream().map(EntityRef::text).collect(Collectors.toSet());
        List<Group> groups = mappedGroups(level.editor(), name -> leaving.contains(name) ? List.of() : List.of(name));
        return groups.equals(level.editor().groups()) ? level : withGroups(level, groups);
    }

    /** Returns a copy's level with the groups of the original, of the copied entities alone. */
    static Level copied(Level copy, EditorNotes notes, Collection<EntityRef> refs) {
        Set<String> copied = refs.stream().map(EntityRef::text).collect(Collectors.toSet());
        List<Group> groups = new ArrayList<>();
        for (Group group : notes.groups()) {
            List<String> members =
                    group.members().stream().filter(copied::contains).toList();
            if (members.size() > 1) {
                groups.add(new Group(group.id(), members));
            }
        }
        return groups.isEmpty() ? copy : withGroups(copy, groups);
    }

    /** Returns an id that no group has. */
    public static String freshGroup(Level level) {
        Set<String> used = level.editor().groups().stream().map(Group::id).collect(Collectors.toSet());
        int number = 1;
        while (used.contains("group-" + number)) {
            number++;
        }
        return "group-" + number;
    }

    /** Returns the level whose notes do not name entities that were removed. */
    public static Level without(Level level, Collection<EntityRef> removed) {
        Set<String> gone = removed.stream().map(EntityRef::text).collect(Collectors.toSet());
        return mapped(level, name -> gone.contains(name) ? List.of() : List.of(name));
    }

    /** Returns the level whose notes have the new name of an entity. */
    public static Level renamed(Level level, EntityRef before, EntityRef after) {
        return replaced(level, Map.of(before, List.of(after)));
    }

    private static Level mapped(Level level, Function<String, List<String>> name) {
        EditorNotes notes = level.editor();
        EditorNotes after = new EditorNotes(
                mappedGroups(notes, name),
                mapped(notes.hidden(), name),
                mapped(notes.locked(), name),
                notes.ignoredProblems());
        return after.equals(notes) ? level : level.with(after);
    }

    private static List<Group> mappedGroups(EditorNotes notes, Function<String, List<String>> name) {
        List<Group> groups = new ArrayList<>();
        for (Group group : notes.groups()) {
            List<String> members = mapped(group.members(), name);
            if (members.equals(group.members())) {
                groups.add(group);
            } else if (members.size() > 1) {
                groups.add(new Group(group.id(), members));
            }
        }
        return groups;
    }

    private static List<String> mapped(List<String> names, Function<String, List<String>> change) {
        return names.stream()
                .flatMap(name -> change.apply(name).stream())
                .distinct()
                .toList();
    }

    private static Level withGroups(Level level, List<Group> groups) {
        EditorNotes notes = level.editor();
        return level.with(
                new EditorNotes(List.copyOf(groups), notes.hidden(), notes.locked(), notes.ignoredProblems()));
    }

    private static Level withHidden(Level level, List<String> hidden) {
        EditorNotes notes = level.editor();
        return level.with(new EditorNotes(notes.groups(), hidden, notes.locked(), notes.ignoredProblems()));
    }

    private static Level withLocked(Level level, List<String> locked) {
        EditorNotes notes = level.editor();
        return level.with(new EditorNotes(notes.groups(), notes.hidden(), locked, notes.ignoredProblems()));
    }

    private static List<String> toggled(List<String> names, Collection<EntityRef> refs) {
        List<String> meant = refs.stream().map(EntityRef::text).toList();
        return names.containsAll(meant)
                ? names.stream().filter(name -> !meant.contains(name)).toList()
                : plus(names, refs);
    }

    private static List<String> plus(List<String> names, Collection<EntityRef> refs) {
        Set<String> all = new LinkedHashSet<>(names);
        refs.forEach(ref -> all.add(ref.text()));
        return List.copyOf(all);
    }
}
