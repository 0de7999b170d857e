package nephele.editor.window.dialog;

import java.awt.Component;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.function.Consumer;
import javax.swing.JDialog;
import javax.swing.SwingUtilities;
import nephele.editor.proving.PixelExplanation;
import nephele.editor.proving.ProvingText;
import nephele.editor.widget.ComponentKeys;
import nephele.engine.level.Language;

/** Makes the dialogue of an explanation, which leaves the editor usable; Esc and Enter close it. */
final class ExplanationDialog {
    private ExplanationDialog() {}

    static JDialog of(Component owner, PixelExplanation explanation, Language language, Consumer<String> copy) {
        JDialog dialog = new JDialog(SwingUtilities.getWindowAncestor(owner), ProvingText.EXPLANATION.in(language));
        ExplanationPanel panel = new ExplanationPanel(explanation, language, copy, dialog::dispose);
        dialog.setDefaultCloseOperation(JDialog.DISPOSE_ON_CLOSE);
        dialog.add(panel);
        dialog.getRootPane().setDefaultButton(panel.closeButton());
        ComponentKeys.bind(dialog.getRootPane(), "ESCAPE", dialog::dispose);
        dialog.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent event) {
                // Not every window system gives the focus back by itself.
                owner.requestFocus();
            }
        });
        dialog.pack();
        dialog.setLocationRelativeTo(owner);
        return dialog;
    }
}
