package nephele.editor.problem;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import nephele.engine.level.Level;

/**
 * The place of an entity in a level's records, from a JSON path such as {@code environment.clouds[2].size}.
 *
 * @param section names of the members that lead to the list, such as {@code environment.clouds}
 * @param index in the list
 * @param rest the path inside the entity, with its leading dot; empty for the entity itself
 */
public record EntityPath(String section, int index, String rest) {
    private static final Pattern ENTRY = Pattern.compile("([A-Za-z.]+)\\[(\\d{1,9})\\](.*)");

    /** Returns the place; empty for a path that leads to no entry of a list of the level. */
    public static Optional<EntityPath> of(Level level, String path) {
        Matcher matcher = ENTRY.matcher(path);
        if (!matcher.matches()) {
            return Optional.empty();
        }
        EntityPath place = new EntityPath(matcher.group(1), Integer.parseInt(matcher.group(2)), matcher.group(3));
        return place.index < place.list(level).size() ? Optional.of(place) : Optional.empty();
    }

    /** Returns {@code section/id}, such as {@code solids/north-wall}; of a nested section, its last name. */
    public String reference(Level level) {
        Object id = entity(level) instanceof Record record ? RecordMembers.get(record, "id") : null;
        return section.substring(section.lastIndexOf('.') + 1) + "/" + (id == null ? index : id);
    }

    /** Returns the entity's id or, if its record has none, its place in the list. */
    public String id(Level level) {
        String reference = reference(level);
        return reference.substring(reference.indexOf('/') + 1);
    }

    /** Returns the entity's record. */
    public Object entity(Level level) {
        return list(level).get(index);
    }

    List<?> list(Level level) {
        Object at = level;
        for (String name : section.split("\\.")) {
            at = at instanceof Record record ? RecordMembers.get(record, name) : null;
        }
        return at instanceof List<?> list ? list : List.of();
    }

    /**
     * Returns a level with another record in an entity's place.
     *
     * @param known the record that is replaced; wherever it is in the list now, by identity
     * @param other {@code null} to delete it
     * @return the same level if the list does not hold it
     */
    Level replaced(Level level, Object known, Object other) {
        List<Object> changed = new ArrayList<>();
        boolean isThere = false;
        for (Object each : list(level)) {
            boolean isIt = each == known && !isThere;
            isThere |= isIt;
            Object kept = isIt ? other : each;
            if (kept != null) {
                changed.add(kept);
            }
        }
        return isThere ? (Level) with(level, section.split("\\."), 0, changed) : level;
    }

    /** Returns a level with another record at this place of the list. */
    Level replacedAt(Level level, Object other) {
        List<Object> changed = new ArrayList<>(list(level));
        changed.set(index, other);
        return (Level) with(level, section.split("\\."), 0, changed);
    }

    /** Returns a level with one more record at the end of the list. */
    Level appended(Level level, Object entity) {
        List<Object> changed = new ArrayList<>(list(level));
        changed.add(Objects.requireNonNull(entity));
        return (Level) with(level, section.split("\\."), 0, changed);
    }

    private static Record with(Record owner, String[] names, int depth, Object value) {
        Object inner = depth == names.length - 1
                ? List.copyOf((List<?>) value)
                : with((Record) RecordMembers.get(owner, names[depth]), names, depth + 1, value);
        return RecordMembers.with(owner, names[depth], inner);
    }
}
