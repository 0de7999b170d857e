package nephele.editor.panel;

import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.DoublePredicate;
import javax.swing.JTextField;
import nephele.editor.panel.model.NumberExpression;
import nephele.editor.widget.Listeners;

/** A text field for a number or a sum; Up and Down change it by a step, Escape takes back what was typed. */
final class NumberInput extends JTextField {
    private final transient DoublePredicate commit;
    private final transient Consumer<String> refuse;
    private final transient TextEntry entry;

    /**
     * @param commit receives a number that was entered; false if it is refused
     * @param refuse called with a text that is no number
     */
    NumberInput(DoublePredicate commit, Consumer<String> refuse) {
        super(5);
        this.commit = commit;
        this.refuse = refuse;
        entry = new TextEntry(this, this::commit);
        addActionListener(event -> entry.enter());
        Listeners.onKey(this, "UP", () -> step(1));
        Listeners.onKey(this, "DOWN", () -> step(-1));
        Listeners.onKey(this, "shift UP", () -> step(0.1));
        Listeners.onKey(this, "shift DOWN", () -> step(-0.1));
        Listeners.onKey(this, "ESCAPE", entry::revert);
    }

    private void step(double change) {
        NumberExpression.evaluate(getText()).ifPresent(value -> commit.test(value + change));
    }

    private boolean commit(String text) {
        OptionalDouble value = NumberExpression.evaluate(text);
        if (value.isEmpty()) {
            refuse.accept(text);
            return false;
        }
        return commit.test(value.getAsDouble());
    }

    /** Shows a number, or a placeholder if it is {@code null}. */
    void show(Double value, String placeholder) {
        entry.show(value == null ? "" : NumberExpression.text(value), placeholder);
    }
}
