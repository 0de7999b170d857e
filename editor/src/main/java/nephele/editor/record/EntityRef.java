package nephele.editor.record;

/**
 * Names an entity of a level: an entry of a list, such as {@code solids/north-wall} or {@code environment.clouds/c1}, or
 * a single record, such as {@code player} or {@code environment.sun}.
 *
 * @param section path of the list or of the single record in the level
 * @param id id of the entry; empty for a single record
 */
public record EntityRef(String section, String id) {
    /** Returns the reference to a single record of the level. */
    public static EntityRef single(String path) {
        return new EntityRef(path, "");
    }

    /** Returns the reference that {@link #text} wrote. */
    public static EntityRef of(String text) {
        int slash = text.indexOf('/');
        return slash < 0 ? single(text) : new EntityRef(text.substring(0, slash), text.substring(slash + 1));
    }

    /** Returns {@code section/id}, or the path of a single record. */
    public String text() {
        return id.isEmpty() ? section : section + "/" + id;
    }

    /** Returns what a list shows: the id, or the last word of the path. */
    public String shortName() {
        return id.isEmpty() ? section.substring(section.lastIndexOf('.') + 1) : id;
    }

    @Override
    public String toString() {
        return text();
    }
}
