package nephele.editor.document;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import nephele.editor.record.EntityRef;

/**
 * The selection: entities in the order of selection, and single faces of solids. Immutable.
 *
 * @param entities without repetition; the last one is the main one, which edits with numbers regard
 */
public record Selection(List<EntityRef> entities, List<FaceRef> faces) {
    public static final Selection NONE = new Selection(List.of(), List.of());

    /** A face of a solid, by the name that {@code Brush} gives it, such as {@code +y} or {@code planes[3]}. */
    public record FaceRef(EntityRef solid, String face) {}

    public Selection {
        entities = List.copyOf(new LinkedHashSet<>(entities));
        faces = List.copyOf(new LinkedHashSet<>(faces));
    }

    /** Returns the selection of entities alone. */
    public static Selection of(Collection<EntityRef> entities) {
        return new Selection(List.copyOf(entities), List.of());
    }

    public static Selection of(EntityRef entity) {
        return of(List.of(entity));
    }

    public boolean isEmpty() {
        return entities.isEmpty() && faces.isEmpty();
    }

    public boolean contains(EntityRef entity) {
        return entities.contains(entity);
    }

    /** Returns this selection with entities added, or removed if all of them are in it. */
    public Selection toggled(Collection<EntityRef> others) {
        Set<EntityRef> result = new LinkedHashSet<>(entities);
        if (result.containsAll(others)) {
            result.removeAll(others);
        } else {
            result.removeAll(others);
            result.addAll(others);
        }
        return new Selection(List.copyOf(result), faces);
    }

    /** Returns this selection with a face added, or removed if it is in it. */
    public Selection toggled(FaceRef face) {
        List<FaceRef> result = new ArrayList<>(faces);
        if (!result.remove(face)) {
            result.add(face);
        }
        return new Selection(entities, result);
    }

    /** Returns this selection without what does not exist. */
    public Selection only(Predicate<EntityRef> exists) {
        return new Selection(
                entities.stream().filter(exists).toList(),
                faces.stream().filter(face -> exists.test(face.solid())).toList());
    }

    /** Returns this selection with another name of an entity. */
    public Selection renamed(EntityRef before, EntityRef after) {
        return new Selection(
                entities.stream().map(ref -> ref.equals(before) ? after : ref).toList(),
                faces.stream()
                        .map(face -> face.solid().equals(before) ? new FaceRef(after, face.face()) : face)
                        .toList());
    }
}
