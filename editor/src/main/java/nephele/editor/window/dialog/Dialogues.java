package nephele.editor.window.dialog;

import java.util.function.Function;
import nephele.editor.window.dialog.DialogFrame.Content;

/** Where dialogues open: over a window, or for a proof without one. */
@FunctionalInterface
public interface Dialogues {
    /** Opens a dialogue; its content is made with what closes it. */
    void open(String title, Function<Runnable, Content> making);
}
