package nephele.editor.panel;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.function.Predicate;
import javax.swing.text.JTextComponent;

/** Commits the text of a component when the focus leaves it, and outlines a text that was refused. */
final class TextEntry {
    private final JTextComponent component;
    private final Predicate<String> commit;
    private String given = "";

    /** @param commit receives a changed text; false if it is refused */
    TextEntry(JTextComponent component, Predicate<String> commit) {
        this.component = component;
        this.commit = commit;
        component.addFocusListener(new FocusAdapter() {
            @Override
            public void focusLost(FocusEvent event) {
                enter();
            }
        });
    }

    /** Commits the text if it differs from the shown one. */
    void enter() {
        if (!component.getText().equals(given)) {
            outline(commit.test(component.getText()) ? null : FlatClientProperties.OUTLINE_ERROR);
        }
    }

    /** Replaces a text that was typed by the shown one. */
    void revert() {
        component.setText(given);
    }

    /** Returns the text of the last call of {@link #show}. */
    String given() {
        return given;
    }

    /** Shows a text and, while it is empty, the placeholder; a focused component keeps what is typed over the same text. */
    void show(String text, String placeholder) {
        component.putClientProperty(FlatClientProperties.PLACEHOLDER_TEXT, placeholder);
        if (!text.equals(given) || !component.hasFocus()) {
            given = text;
            outline(null);
            if (!component.getText().equals(text)) {
                component.setText(text);
                // A text that does not fit shows its beginning.
                component.setCaretPosition(0);
            }
        }
    }

    private void outline(Object outline) {
        component.putClientProperty(FlatClientProperties.OUTLINE, outline);
    }
}
