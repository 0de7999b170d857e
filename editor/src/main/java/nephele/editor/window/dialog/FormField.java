package nephele.editor.window.dialog;

import java.util.List;
import java.util.function.Function;
import nephele.editor.session.EditorSession;
import nephele.editor.text.Words;

/**
 * A value that a form asks for.
 *
 * @param name of the action's parameter
 * @param initial the text at first
 */
record FormField(String name, Words label, Input input, Function<EditorSession, String> initial) {
    /** The component for a value. */
    sealed interface Input {
        /** Several numbers side by side, written with commas between them. */
        record Numbers(int count) implements Input {}

        record Text() implements Input {}

        record Choice(Function<EditorSession, List<Option>> options) implements Input {}
    }

    /** A value of a choice, and its name. */
    record Option(String value, Words label) {}

    static FormField vector(String name, DialogText label, Function<EditorSession, String> initial) {
        return new FormField(name, label.words(), new Input.Numbers(3), initial);
    }

    static FormField number(String name, DialogText label, Function<EditorSession, String> initial) {
        return new FormField(name, label.words(), new Input.Numbers(1), initial);
    }

    static FormField choice(String name, DialogText label, Function<EditorSession, List<Option>> options) {
        return new FormField(name, label.words(), new Input.Choice(options), session -> "");
    }
}
