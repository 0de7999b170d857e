package nephele.editor.panel.model;

import java.util.List;
import nephele.editor.record.EntityRef;

/**
 * A line of the outliner.
 *
 * @param key names the line as long as it exists
 * @param depth steps of indentation
 * @param members the entities that eye, lock and selection regard: one, or those of the group or section
 * @param state icons of the line
 */
public record OutlinerRow(Kind kind, String key, int depth, String title, List<EntityRef> members, State state) {
    /** The kind of a row. */
    public enum Kind {
        /** The heading of all groups. */
        GROUPS,
        GROUP,
        SECTION,
        ENTITY
    }

    /** The state of a row's icons; that of a group or section holds if it holds for all members. */
    public record State(boolean isOpen, boolean isHidden, boolean isLocked) {}

    /** Returns true if the line can be folded. */
    public boolean hasFold() {
        return kind != Kind.ENTITY;
    }

    /** Returns what a selection of the line selects; a section's line selects nothing. */
    public List<EntityRef> selected() {
        return kind == Kind.ENTITY || kind == Kind.GROUP ? members : List.of();
    }
}
