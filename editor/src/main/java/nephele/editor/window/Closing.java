package nephele.editor.window;

import java.util.function.BiFunction;
import java.util.function.BooleanSupplier;
import nephele.editor.session.EditorSession;
import nephele.engine.level.Language;

/**
 * Decides whether a window may close.
 *
 * @param question asks, in a language, what happens to the unsaved changes of the level of a name
 * @param save saves the level; false if it was not saved
 */
public record Closing(EditorSession session, BiFunction<String, Language, Choice> question, BooleanSupplier save) {
    /** Returns true if nothing is lost by closing, or if the user agrees to lose it. */
    public boolean isAllowed() {
        if (!session.document().isModified()) {
            return true;
        }
        return switch (question.apply(EditorWindow.name(session), session.language())) {
            case SAVE -> save.getAsBoolean();
            case DISCARD -> true;
            case CANCEL -> false;
        };
    }

    /** The user's choice about unsaved changes. */
    public enum Choice {
        SAVE,
        DISCARD,
        CANCEL
    }
}
