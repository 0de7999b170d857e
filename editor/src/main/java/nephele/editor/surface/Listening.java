package nephele.editor.surface;

import java.awt.Component;
import java.awt.event.KeyListener;
import java.awt.event.MouseAdapter;

/** Registers listeners of all input with a component. */
final class Listening {
    private Listening() {}

    static void add(Component component, MouseAdapter mouse, KeyListener keys) {
        component.addMouseListener(mouse);
        component.addMouseMotionListener(mouse);
        component.addMouseWheelListener(mouse);
        component.addKeyListener(keys);
        // Tab and the arrows belong to the viewport, not to the traversal of focus.
        component.setFocusTraversalKeysEnabled(false);
    }
}
