package nephele.editor.window.file;

import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.KeyStroke;

/** Keys of a whole dialogue. */
final class DialogueKeys {
    private DialogueKeys() {}

    /** Runs something when a key such as {@code ESCAPE} is pressed anywhere in a panel. */
    static void bind(JPanel panel, String key, Runnable effect) {
        panel.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke(key), key);
        panel.getActionMap().put(key, new AbstractAction() {
            private static final long serialVersionUID = 1;

            @Override
            public void actionPerformed(ActionEvent event) {
                effect.run();
            }
        });
    }
}
