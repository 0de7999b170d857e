package nephele.editor.widget;

import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/** Keys of a component and of the components in it. */
public final class ComponentKeys {
    private ComponentKeys() {}

    /** Runs an effect when a key such as {@code ESCAPE} is pressed while the focus is in a component. */
    public static void bind(JComponent part, String key, Runnable effect) {
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
