package nephele.editor.panel;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.event.ActionEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.OptionalDouble;
import java.util.function.DoublePredicate;
import javax.swing.AbstractAction;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import nephele.editor.panel.model.NumberExpression;

/** A text field for a number or a sum; Up and Down change it by a step, Escape takes back what was typed. */
final class NumberInput extends JTextField {
    private final transient DoublePredicate commit;
    private final transient Runnable refuse;
    private String shown = "";

    /**
     * @param commit receives a number that was entered; false if it is refused
     * @param refuse called with a text that is no number
     */
    NumberInput(DoublePredicate commit, Runnable refuse) {
        super(5);
        this.commit = commit;
        this.refuse = refuse;
        addActionListener(event -> enter());
        addFocusListener(new FocusAdapter() {
            @Override
            public void focusLost(FocusEvent event) {
                enter();
            }
        });
        key("UP", () -> step(1));
        key("DOWN", () -> step(-1));
        key("shift UP", () -> step(0.1));
        key("shift DOWN", () -> step(-0.1));
        key("ESCAPE", () -> setText(shown));
    }

    private void key(String stroke, Runnable action) {
        getInputMap().put(KeyStroke.getKeyStroke(stroke), stroke);
        getActionMap().put(stroke, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                action.run();
            }
        });
    }

    private void step(double change) {
        NumberExpression.evaluate(getText()).ifPresent(value -> commit.test(value + change));
    }

    private void enter() {
        if (getText().equals(shown)) {
            return;
        }
        OptionalDouble value = NumberExpression.evaluate(getText());
        if (value.isEmpty()) {
            refuse.run();
        } else if (commit.test(value.getAsDouble())) {
            mark(null);
            return;
        }
        mark(FlatClientProperties.OUTLINE_ERROR);
    }

    private void mark(Object outline) {
        putClientProperty(FlatClientProperties.OUTLINE, outline);
    }

    /** Shows a number, or a placeholder if it is {@code null}. */
    void show(Double value, String placeholder) {
        putClientProperty(FlatClientProperties.PLACEHOLDER_TEXT, placeholder);
        String text = value == null ? "" : NumberExpression.text(value);
        if (!text.equals(shown) || !hasFocus()) {
            mark(null);
            shown = text;
            if (!getText().equals(text)) {
                setText(text);
            }
        }
    }
}
