package nephele.workshop.prove.editor;

import java.util.HashSet;
import java.util.Set;
import nephele.editor.record.Entities;
import nephele.editor.session.EditorSession;
import nephele.engine.level.Level;

/**
 * Tells the texts that name something of the user from those of the editor: an id of the level, or a path of files. They
 * have any length, and may end in "…" where they are shown.
 */
public record UserTexts(Set<String> ids) {
    /** Only paths are the user's. */
    public static final UserTexts PATHS = new UserTexts(Set.of());

    /** Returns the texts of the level that a session has open. */
    public static UserTexts of(EditorSession session) {
        Level level = session.document().level();
        Set<String> ids = new HashSet<>();
        Entities.LEVEL.all(level).forEach(ref -> ids.add(ref.id()));
        ids.remove("");
        return new UserTexts(Set.copyOf(ids));
    }

    /** Returns true if a text names something of the user. */
    public boolean holds(String text) {
        return text.indexOf('/') >= 0 || ids.stream().anyMatch(text::contains);
    }
}
