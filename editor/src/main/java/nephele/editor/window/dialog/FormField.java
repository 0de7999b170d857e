package nephele.editor.window.dialog;

import java.util.List;
import java.util.function.Function;
import nephele.editor.session.EditorSession;
import nephele.editor.text.Words;

/**
 * A value that a form asks for.
 *
 * @param name of the action's parameter
 * @param numbers how many numbers it has, written with commas between them; 0 for any text
 * @param initial the text at first
 * @param options the values to choose from; {@code null} if the value is typed
 */
record FormField(
        String name,
        Words label,
        int numbers,
        Function<EditorSession, String> initial,
        Function<EditorSession, List<Option>> options) {
    /** A value of a choice, and its name. */
    record Option(String value, Words label) {}

    static FormField text(String name, DialogText label, Function<EditorSession, String> initial) {
        return new FormField(name, label.words(), 0, initial, null);
    }

    static FormField number(String name, DialogText label, Function<EditorSession, String> initial) {
        return new FormField(name, label.words(), 1, initial, null);
    }

    static FormField vector(String name, DialogText label, Function<EditorSession, String> initial) {
        return new FormField(name, label.words(), 3, initial, null);
    }

    static FormField choice(String name, DialogText label, Function<EditorSession, List<Option>> options) {
        return new FormField(name, label.words(), 0, session -> "", options);
    }

    boolean isChoice() {
        return options != null;
    }
}
