package nephele.editor.window;

import java.awt.Component;
import java.awt.KeyEventDispatcher;
import java.awt.Window;
import java.awt.event.KeyEvent;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import javax.swing.MenuSelectionManager;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;

/** Sends the keys of one window to its editor, unless the component that has the focus needs them itself. */
final class WindowKeys implements KeyEventDispatcher {
    private final Window window;
    private final EditorPanel panel;

    WindowKeys(Window window, EditorPanel panel) {
        this.window = window;
        this.panel = panel;
    }

    @Override
    public boolean dispatchKeyEvent(KeyEvent event) {
        Component focus = event.getComponent();
        boolean isElsewhere = focus == null
                || focus != window && SwingUtilities.getWindowAncestor(focus) != window
                || MenuSelectionManager.defaultManager().getSelectedPath().length > 0;
        return !isElsewhere && !belongsTo(focus, event) && panel.key(event);
    }

    /** Returns true if a component has a use for a key of its own. */
    static boolean belongsTo(Component focus, KeyEvent event) {
        boolean isPlain = !event.isControlDown() && !event.isAltDown() && !event.isMetaDown();
        boolean isFunction = event.getKeyCode() >= KeyEvent.VK_F1 && event.getKeyCode() <= KeyEvent.VK_F12;
        if (focus instanceof JTextComponent && isPlain && !isFunction) {
            return true;
        }
        boolean mayBind = focus instanceof JTextComponent || isPlain;
        return mayBind && focus instanceof JComponent component && isBound(component, event);
    }

    private static boolean isBound(JComponent component, KeyEvent event) {
        KeyStroke stroke = KeyStroke.getKeyStrokeForEvent(event);
        return component.getInputMap(JComponent.WHEN_FOCUSED).get(stroke) != null
                || component
                                .getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
                                .get(stroke)
                        != null;
    }
}
