package nephele.editor.window.dialog;

import com.formdev.flatlaf.FlatClientProperties;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import nephele.editor.panel.model.NumberExpression;
import nephele.editor.session.EditorSession;
import nephele.editor.text.Words;
import nephele.editor.widget.Listeners;
import nephele.editor.widget.WordCell;
import nephele.engine.level.Language;
import net.miginfocom.swing.MigLayout;

/** The component of a form's value: text fields, or a choice. */
final class FormInput {
    private static final String AXES = "xyz";

    private final FormField field;
    private final Language language;
    private final List<JTextField> texts = new ArrayList<>();
    private final JComboBox<FormField.Option> choice = new JComboBox<>();
    private final JComponent component;

    FormInput(FormField field, EditorSession session, Runnable changed) {
        this.field = field;
        language = session.language();
        component = component(session, changed);
    }

    private JComponent component(EditorSession session, Runnable changed) {
        String name = field.label().in(language);
        if (field.isChoice()) {
            field.options().apply(session).forEach(choice::addItem);
            choice.setRenderer(
                    new WordCell<FormField.Option>(option -> option.label().in(language)));
            choice.getAccessibleContext().setAccessibleName(name);
            choice.addActionListener(event -> changed.run());
            return choice;
        }
        int count = Math.max(1, field.numbers());
        String[] values = field.initial().apply(session).split(",", count);
        JPanel row = new JPanel(new MigLayout("insets 0, gap 6, fill", ""));
        for (int i = 0; i < count; i++) {
            JTextField text = new JTextField(i < values.length ? values[i] : "", count == 1 ? 18 : 8);
            text.getAccessibleContext().setAccessibleName(count == 1 ? name : name + " " + AXES.charAt(i));
            Listeners.onText(text, changed);
            text.selectAll();
            if (count > 1) {
                row.add(new JLabel(AXES.substring(i, i + 1)));
            }
            row.add(text, "grow, push");
            texts.add(text);
        }
        return row;
    }

    JComponent component() {
        return component;
    }

    FormField field() {
        return field;
    }

    /** Returns the component that takes the keyboard first. */
    JComponent first() {
        return texts.isEmpty() ? choice : texts.get(0);
    }

    /** Marks the value as wrong or right. */
    void mark(boolean isWrong) {
        texts.forEach(text -> text.putClientProperty(
                FlatClientProperties.OUTLINE, isWrong ? FlatClientProperties.OUTLINE_ERROR : null));
    }

    /** Returns what is wrong, or {@link Words#NONE}. */
    Words problem() {
        if (field.numbers() > 0) {
            boolean areNumbers = texts.stream()
                    .allMatch(text -> NumberExpression.evaluate(text.getText()).isPresent());
            return areNumbers ? Words.NONE : DialogText.NO_NUMBER.with(field.label());
        }
        boolean isEmpty = field.isChoice()
                ? choice.getSelectedItem() == null
                : texts.get(0).getText().isBlank();
        return isEmpty ? DialogText.IS_EMPTY.with(field.label()) : Words.NONE;
    }

    /** Returns the value as a script writes it. */
    String value() {
        if (field.numbers() > 0) {
            return String.join(",", texts.stream().map(FormInput::number).toList());
        }
        return choice.getSelectedItem() instanceof FormField.Option option
                ? option.value()
                : texts.isEmpty() ? "" : texts.get(0).getText().strip();
    }

    private static String number(JTextField text) {
        OptionalDouble value = NumberExpression.evaluate(text.getText());
        return value.isPresent() ? String.valueOf(value.getAsDouble()) : text.getText();
    }
}
