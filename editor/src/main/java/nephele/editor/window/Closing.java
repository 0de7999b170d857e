package nephele.editor.window;

import java.util.function.BooleanSupplier;
import nephele.editor.session.EditorSession;
import nephele.engine.level.Language;

/**
 * Decides whether a window may close.
 *
 * @param save saves the level; false if it was not saved
 */
public record Closing(EditorSession session, CloseQuestion question, BooleanSupplier save) {
    /** Returns true if nothing is lost by closing, or if the user agrees to lose it. */
    public boolean isAllowed() {
        if (!session.document().isModified()) {
            return true;
        }
        return switch (question.ask(EditorWindow.name(session), session.language())) {
            case SAVE -> save.getAsBoolean();
            case DISCARD -> true;
            case CANCEL -> false;
        };
    }

    /** Asks what happens to unsaved changes. */
    @FunctionalInterface
    public interface CloseQuestion {
        /** The user's choice. */
        enum Choice {
            SAVE,
            DISCARD,
            CANCEL
        }

        /** Asks about the level of this name. */
        Choice ask(String level, Language language);
    }
}
