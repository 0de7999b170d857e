package nephele.editor.problem;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.EntitySection;
import nephele.editor.record.RecordKind;
import nephele.engine.level.Level;

/**
 * The place of an entity in a level's records, from a JSON path such as {@code environment.clouds[2].size}.
 *
 * @param index in the section's list
 * @param rest the path inside the entity, with its leading dot; empty for the entity itself
 */
record EntityPath(EntitySection section, int index, String rest) {
    private static final Pattern ENTRY = Pattern.compile("([A-Za-z.]+)\\[(\\d{1,9})\\](.*)");

    /** Returns the place; empty for a path that leads to no entity of the level. */
    static Optional<EntityPath> of(Level level, String path) {
        Matcher matcher = ENTRY.matcher(path);
        if (!matcher.matches()) {
            return Optional.empty();
        }
        int index = Integer.parseInt(matcher.group(2));
        return Entities.LEVEL
                .list(matcher.group(1))
                .filter(section -> index < section.entities(level).size())
                .map(section -> new EntityPath(section, index, matcher.group(3)));
    }

    /** Returns the entity's name, such as {@code solids/north-wall}. */
    EntityRef reference(Level level) {
        return new EntityRef(section.path(), RecordKind.id(entity(level)));
    }

    /** Returns the entity's record. */
    Record entity(Level level) {
        return section.entities(level).get(index);
    }

    /**
     * Returns a level with another record in an entity's place.
     *
     * @param known the record that is replaced; wherever it is in the list now, by identity
     * @param other {@code null} to delete it
     * @return the same level if the list does not hold it
     */
    Level replaced(Level level, Record known, Record other) {
        List<Record> changed = new ArrayList<>();
        boolean isThere = false;
        for (Record each : section.entities(level)) {
            boolean isIt = each == known && !isThere;
            isThere |= isIt;
            Record kept = isIt ? other : each;
            if (kept != null) {
                changed.add(kept);
            }
        }
        return isThere ? (Level) section.with(level, changed) : level;
    }

    /** Returns a level with another record at this place of the list. */
    Level replacedAt(Level level, Record other) {
        List<Record> changed = new ArrayList<>(section.entities(level));
        changed.set(index, other);
        return (Level) section.with(level, changed);
    }
}
