package nephele.editor.tool;

import java.util.List;
import nephele.editor.pane.Mark;
import nephele.editor.text.Words;

/**
 * A tool in use. It shows what a drag would do by {@code Document.drag} and makes it one step by {@code
 * Document.commitDrag} when the button is released.
 */
public interface Tool {
    /** The pointer moved without a button. */
    default void moved(Pointer pointer) {}

    /** The pointer left the viewport: what it pointed at is not shown any more. */
    default void left() {}

    void pressed(Pointer pointer);

    void dragged(Pointer pointer);

    void released(Pointer pointer);

    /** Ends what is in progress; the document is then exactly as before it. Also called before another tool is taken. */
    void cancel();

    /** Applies what the tool has prepared, as Enter asks; returns false if there is nothing. */
    default boolean confirm() {
        return false;
    }

    /** Returns what to draw over the picture now. */
    List<Mark> marks();

    /** Returns a line for the status bar: what the pointer would do. */
    Words hint();
}
