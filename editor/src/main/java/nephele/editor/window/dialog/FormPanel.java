package nephele.editor.window.dialog;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import nephele.editor.session.EditorSession;
import nephele.editor.text.Words;
import net.miginfocom.swing.MigLayout;

/** The fields of a form with its buttons; what is wrong is reported in words while the user types. */
final class FormPanel extends JPanel {
    private static final long serialVersionUID = 1;
    private static final int LEAST_WIDTH_POINTS = 380;

    private final transient ActionForm form;
    private final transient EditorSession session;
    private final transient Function<Map<String, String>, Words> run;
    private final transient Runnable close;
    private final transient List<FormInput> inputs = new ArrayList<>();
    private final JLabel message = new JLabel(" ");
    private final JButton accept = new JButton();

    /**
     * Creates a form with the values of the session.
     *
     * @param run does it; returns what went wrong or {@link Words#NONE}, after which the form closes
     */
    FormPanel(ActionForm form, EditorSession session, Function<Map<String, String>, Words> run, Runnable close) {
        super(new MigLayout("insets 12, fillx, wrap 2", "[][grow, fill]", ""));
        this.form = form;
        this.session = session;
        this.run = run;
        this.close = close;
        for (FormField field : form.fields()) {
            FormInput input = new FormInput(field, session, this::check);
            inputs.add(input);
            JLabel label = new JLabel(field.label().in(session.language()));
            label.setLabelFor(input.first());
            add(label);
            add(input.component());
        }
        message.setForeground(DialogFrame.errorColour());
        message.setName("message");
        add(message, "span 2, growx, wmin 0");
        JButton cancel = new JButton(DialogText.CANCEL.in(session.language()));
        cancel.addActionListener(event -> close.run());
        accept.setText(DialogText.OK.in(session.language()));
        accept.setName("accept");
        accept.addActionListener(event -> accept());
        add(accept, "span 2, split 2, right, sg, tag ok");
        add(cancel, "sg, tag cancel");
        check();
    }

    private Map<String, String> values() {
        Map<String, String> values = new LinkedHashMap<>();
        inputs.forEach(input -> values.put(input.field().name(), input.value()));
        return values;
    }

    /** Tells the first problem and marks where it is. */
    private void check() {
        Optional<FormInput> wrong = inputs.stream()
                .filter(input -> !input.problem().equals(Words.NONE))
                .findFirst();
        Words problem =
                wrong.map(FormInput::problem).orElseGet(() -> form.check().apply(session, values()));
        boolean isWrong = !problem.equals(Words.NONE);
        inputs.forEach(input -> input.mark(isWrong && wrong.map(input::equals).orElse(true)));
        report(problem);
        accept.setEnabled(!isWrong);
    }

    private void report(Words words) {
        String text = words.in(session.language());
        message.setText(text.isEmpty() ? " " : text);
        message.setToolTipText(text.isEmpty() ? null : text);
    }

    private void accept() {
        Words failure = run.apply(values());
        report(failure);
        if (failure.equals(Words.NONE)) {
            close.run();
        }
    }

    JButton acceptButton() {
        return accept;
    }

    JComponent first() {
        return inputs.get(0).first();
    }

    @Override
    public Dimension getPreferredSize() {
        Dimension size = super.getPreferredSize();
        return new Dimension(Math.max(UIScale.scale(LEAST_WIDTH_POINTS), size.width), size.height);
    }
}
