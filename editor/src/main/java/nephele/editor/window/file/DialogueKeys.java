package nephele.editor.window.file;

import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/** Keys of a dialogue or of a part of it. */
final class DialogueKeys {
    private DialogueKeys() {}

    /** Runs something when a key such as {@code ESCAPE} is pressed anywhere in a component. */
    static void bind(JComponent part, String key, Runnable effect) {
        part.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke(key), key);
        part.getActionMap().put(key, new AbstractAction() {
            private static final long serialVersionUID = 1;

            @Override
            public void actionPerformed(ActionEvent event) {
                effect.run();
            }
        });
    }
}
