package nephele.editor.window.page;

import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JLabel;
import nephele.editor.action.KeyText;

/** A line that waits for one key. Tab and Enter are keys like all others for it; Esc gives up. */
final class KeyCapture extends JLabel {
    private static final long serialVersionUID = 1;

    private transient Consumer<Optional<KeyText>> waiting;

    KeyCapture() {
        setFocusable(true);
        setFocusTraversalKeysEnabled(false);
        addKeyListener(new KeyAdapter() {
            @Override
            public void keyPressed(KeyEvent event) {
                pressed(event);
            }
        });
    }

    /** Shows a prompt and takes the keyboard until a key is pressed. */
    void await(String prompt, Consumer<Optional<KeyText>> taken) {
        setText(prompt);
        waiting = taken;
        requestFocusInWindow();
    }

    void pressed(KeyEvent event) {
        if (waiting == null) {
            return;
        }
        boolean isEnd = event.getKeyCode() == KeyEvent.VK_ESCAPE;
        Optional<KeyText> key = isEnd ? Optional.empty() : KeyText.pressed(event);
        event.consume();
        if (isEnd || key.isPresent()) {
            Consumer<Optional<KeyText>> taken = waiting;
            waiting = null;
            taken.accept(key);
        }
    }
}
