package nephele.editor.action;

import java.util.List;
import java.util.function.BooleanSupplier;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.text.Words;

/**
 * An action or a tool of one session, ready to run.
 *
 * @param id the action's, or {@code tool-} and the tool's; names it in the settings' key bindings
 * @param keys default keys as {@link KeyText} reads them
 * @param isChosen true while its choice holds, such as for the tool in use
 * @param effect runs it; a failure is told to the user by the session's status
 */
public record EditorCommand(
        String id,
        Words title,
        Menu menu,
        List<String> keys,
        BooleanSupplier isEnabled,
        BooleanSupplier isChosen,
        Runnable effect) {
    /** Begins the id of every command that takes a tool. */
    public static final String TOOL = "tool-";

    /** Runs the command if it is possible now. */
    public void run() {
        if (isEnabled.getAsBoolean()) {
            effect.run();
        }
    }

    /** Returns true if it takes a tool. */
    public boolean isTool() {
        return id.startsWith(TOOL);
    }
}
