package nephele.editor.window.dialog;

import java.awt.Component;
import java.awt.Desktop;
import java.awt.GraphicsEnvironment;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Consumer;
import javax.swing.JDialog;
import javax.swing.SwingUtilities;
import nephele.editor.proving.PixelExplanation;
import nephele.editor.proving.ProvingText;
import nephele.editor.proving.ProvingThreads;
import nephele.editor.session.EditorSession;
import nephele.editor.widget.Listeners;
import nephele.editor.window.WindowInterface;
import nephele.engine.level.Language;

/** Gives the proofs of a session a window: threads for their work, a dialogue and the browser for their results. */
public final class ProvingWindow {
    private final EditorSession session;
    private final WindowInterface ui;

    private ProvingWindow(EditorSession session, WindowInterface ui) {
        this.session = session;
        this.ui = ui;
    }

    /** Connects the proofs with a window, once. */
    public static void connect(EditorSession session, WindowInterface ui, Component owner) {
        ProvingWindow window = new ProvingWindow(session, ui);
        session.proving().runOn(ProvingThreads.background(SwingUtilities::invokeLater));
        ui.part("explanation", () -> window.explain(owner));
        ui.part("trade-page", window::browse);
    }

    private void explain(Component owner) {
        session.proving()
                .explain(found -> of(owner, found, session.language(), ui::copy).setVisible(true));
    }

    /** Opens the page; without a browser, its path stays in the status line. */
    private void browse() {
        session.proving().trade().page().ifPresent(page -> {
            if (!isBrowsed(page)) {
                session.status(ProvingText.TRADE_DONE.with(page));
            }
        });
    }

    private static boolean isBrowsed(Path page) {
        boolean isPossible = !GraphicsEnvironment.isHeadless()
                && Desktop.isDesktopSupported()
                && Desktop.getDesktop().isSupported(Desktop.Action.BROWSE);
        if (!isPossible) {
            return false;
        }
        try {
            Desktop.getDesktop().browse(page.toUri());
            return true;
        } catch (IOException | UnsupportedOperationException withoutBrowser) {
            return false;
        }
    }

    private static JDialog of(Component owner, PixelExplanation explanation, Language language, Consumer<String> copy) {
        JDialog dialog = new JDialog(SwingUtilities.getWindowAncestor(owner), ProvingText.EXPLANATION.in(language));
        ExplanationPanel panel = new ExplanationPanel(explanation, language, copy, dialog::dispose);
        dialog.setDefaultCloseOperation(JDialog.DISPOSE_ON_CLOSE);
        dialog.add(panel);
        dialog.getRootPane().setDefaultButton(panel.closeButton());
        Listeners.onKey(dialog.getRootPane(), "ESCAPE", dialog::dispose);
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
