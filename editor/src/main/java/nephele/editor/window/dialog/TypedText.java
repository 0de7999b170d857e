package nephele.editor.window.dialog;

import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;

/** Calls an action after each change of a text. */
record TypedText(Runnable changed) implements DocumentListener {
    @Override
    public void insertUpdate(DocumentEvent event) {
        changed.run();
    }

    @Override
    public void removeUpdate(DocumentEvent event) {
        changed.run();
    }

    @Override
    public void changedUpdate(DocumentEvent event) {
        changed.run();
    }
}
