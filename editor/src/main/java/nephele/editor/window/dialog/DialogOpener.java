package nephele.editor.window.dialog;

import java.util.function.Function;

/** Shows dialogues: in windows, or where there is no display. */
@FunctionalInterface
public interface DialogOpener {
    /** Opens a dialogue; its content is made with what closes it. */
    void open(String title, Function<Runnable, DialogFrame.Content> making);
}
