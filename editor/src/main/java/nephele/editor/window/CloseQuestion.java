package nephele.editor.window;

import nephele.engine.level.Language;

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
