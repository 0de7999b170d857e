package nephele.editor.panel;

import java.util.Optional;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.text.JTextComponent;
import nephele.editor.panel.model.InspectorField;
import nephele.editor.panel.model.PanelText;
import nephele.engine.level.TextKind;
import net.miginfocom.swing.MigLayout;

/** A text field, of several lines for prose, with a button for a file. */
final class TextEditor {
    private final FieldChanges changes;
    private final JPanel panel = new JPanel(new MigLayout("insets 0, gap 2, fill", "[grow, fill][]", ""));
    private final TextEntry entry;
    private final AssetChooser chooser;
    /** {@code null} if the text names no file. */
    private final JButton choose;

    private InspectorField field;

    /** @param chooser {@code null} if the text names no file */
    TextEditor(InspectorField field, FieldChanges changes, AssetChooser chooser) {
        this.field = field;
        this.changes = changes;
        this.chooser = chooser;
        boolean isProse = field.type().field().declaration().text() == TextKind.PROSE;
        JTextComponent text = isProse ? area() : new JTextField(8);
        entry = new TextEntry(text, value -> changes.set(this.field, value));
        if (text instanceof JTextField line) {
            line.addActionListener(event -> entry.enter());
        }
        text.getAccessibleContext().setAccessibleName(field.words().in(changes.language()));
        panel.add(isProse ? new JScrollPane(text) : text, "wmin 40, grow");
        if (chooser != null) {
            choose = new JButton("…");
            choose.getAccessibleContext()
                    .setAccessibleName(PanelText.CHOOSE_FILE
                            .with(field.words().in(changes.language()))
                            .in(changes.language()));
            choose.addActionListener(
                    event -> chooser.choose(this.field, entry.given()).ifPresent(id -> changes.set(this.field, id)));
            panel.add(choose);
        } else {
            choose = null;
        }
    }

    private static JTextComponent area() {
        var area = new JTextArea(3, 8);
        area.setLineWrap(true);
        area.setWrapStyleWord(true);
        // Tab goes to the next field as everywhere else.
        area.setFocusTraversalKeys(0, null);
        area.setFocusTraversalKeys(1, null);
        return area;
    }

    private void showPicture() {
        if (choose != null) {
            Optional<Icon> picture = chooser.picture(entry.given());
            choose.setIcon(picture.orElse(null));
            choose.setText(picture.isPresent() ? "" : "…");
        }
    }

    FieldEditor editor() {
        return new FieldEditor(panel, this::show);
    }

    private void show(InspectorField next) {
        field = next;
        entry.show(next.value() instanceof String text ? text : "", FieldEditor.placeholder(next, changes));
        showPicture();
    }
}
