package nephele.editor.window;

import java.awt.event.KeyEvent;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.KeyStroke;

/**
 * An item of a menu that shows its key but does not react to it: {@code EditorKeys} finds commands by keys, so that a
 * letter typed into a text field starts none.
 */
final class CommandMenuItem extends JCheckBoxMenuItem {
    private static final long serialVersionUID = 1;

    @Override
    protected boolean processKeyBinding(KeyStroke stroke, KeyEvent event, int condition, boolean isPressed) {
        return false;
    }
}
