package nephele.editor.window;

import java.nio.file.Path;
import nephele.editor.session.EditorSession;

/** The title of a window. */
final class EditorTitle {
    private EditorTitle() {}

    /** Returns the level's file name, or a word for none. */
    static String name(EditorSession session) {
        return session.file()
                .path()
                .map(Path::getFileName)
                .map(Path::toString)
                .orElseGet(() -> WindowText.UNTITLED.in(session.language()));
    }

    /** Returns the title, with an asterisk if something is not saved. */
    static String of(EditorSession session) {
        String mark = session.document().isModified() ? "*" : "";
        return mark + name(session) + " – " + WindowText.TITLE.in(session.language());
    }
}
