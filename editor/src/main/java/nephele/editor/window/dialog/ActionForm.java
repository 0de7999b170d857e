package nephele.editor.window.dialog;

import java.util.List;
import java.util.Map;
import nephele.editor.session.EditorSession;
import nephele.editor.text.Words;

/**
 * A form that asks for the parameters of an action.
 *
 * @param part the name by which the window shows it; that of the action if it replaces its use without parameters
 * @param action id of the action that it runs
 * @param check tells what is wrong with the values beyond their grammar
 */
record ActionForm(String part, String action, Words title, List<FormField> fields, Check check) {
    /** Tells what is wrong with some values. */
    @FunctionalInterface
    interface Check {
        /** Returns what is wrong, or {@link Words#NONE}. */
        Words problem(EditorSession session, Map<String, String> values);
    }

    static final Check NO_CHECK = (session, values) -> Words.NONE;

    static ActionForm of(String action, DialogText title, FormField... fields) {
        return new ActionForm(action, action, title.words(), List.of(fields), NO_CHECK);
    }

    ActionForm shownAs(String otherPart) {
        return new ActionForm(otherPart, action, title, fields, check);
    }

    ActionForm checkedBy(Check live) {
        return new ActionForm(part, action, title, fields, live);
    }
}
