package nephele.editor.widget;

import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;

/** Calls an action after each change of a text. */
public record TextListener(Runnable action) implements DocumentListener {
    @Override
    public void insertUpdate(DocumentEvent event) {
        action.run();
    }

    @Override
    public void removeUpdate(DocumentEvent event) {
        action.run();
    }

    @Override
    public void changedUpdate(DocumentEvent event) {
        action.run();
    }
}
