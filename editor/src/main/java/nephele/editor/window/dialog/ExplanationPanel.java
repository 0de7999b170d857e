package nephele.editor.window.dialog;

import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.UIManager;
import nephele.editor.proving.PixelExplanation;
import nephele.editor.proving.ProvingText;
import nephele.engine.level.Language;
import net.miginfocom.swing.MigLayout;

/** The explanation of a pixel as text that can be selected and copied. */
public final class ExplanationPanel extends JPanel {
    private static final long serialVersionUID = 1;

    private final JButton close = new JButton();

    /** @param copy receives the whole text, for the clipboard */
    public ExplanationPanel(PixelExplanation explanation, Language language, Consumer<String> copy, Runnable closed) {
        super(new MigLayout("insets 12, fill, wrap 1", "[grow, fill]", "[grow, fill][]"));
        JTextArea text = new JTextArea(explanation.text());
        text.setFont(UIManager.getFont("monospaced.font"));
        text.setEditable(false);
        text.setLineWrap(true);
        text.setWrapStyleWord(true);
        text.setCaretPosition(0);
        text.setRows(18);
        text.setColumns(72);
        text.getAccessibleContext().setAccessibleName(ProvingText.EXPLANATION.in(language));
        JButton copied = new JButton(ProvingText.COPY.in(language));
        copied.addActionListener(event -> copy.accept(explanation.text()));
        close.setText(ProvingText.CLOSE.in(language));
        close.addActionListener(event -> closed.run());
        add(new JScrollPane(text));
        JPanel buttons = new JPanel(new MigLayout("insets 0", "[grow][][]"));
        buttons.add(copied, "skip 1");
        buttons.add(close);
        add(buttons);
    }

    JButton closeButton() {
        return close;
    }
}
