package nephele.editor.document;

import nephele.engine.level.Level;

/** A state of the document: the level and what is selected in it. Immutable; snapshots share unchanged parts. */
public record Snapshot(Level level, Selection selection) {
    public Snapshot with(Level other) {
        return new Snapshot(other, selection);
    }

    public Snapshot with(Selection other) {
        return new Snapshot(level, other);
    }
}
