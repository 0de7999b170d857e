package nephele.editor.window.dialog;

import java.awt.Component;
import java.awt.Desktop;
import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.nio.file.Path;
import javax.swing.SwingUtilities;
import nephele.editor.proving.ProvingText;
import nephele.editor.proving.ProvingThreads;
import nephele.editor.session.EditorSession;
import nephele.editor.window.WindowDesk;

/** Gives the proofs of a session a window: threads for their work, a dialogue and the browser for their results. */
public final class ProvingWindow {
    private final EditorSession session;
    private final WindowDesk desk;

    private ProvingWindow(EditorSession session, WindowDesk desk) {
        this.session = session;
        this.desk = desk;
    }

    /** Connects the proofs with a window, once. */
    public static void connect(EditorSession session, WindowDesk desk, Component owner) {
        ProvingWindow window = new ProvingWindow(session, desk);
        session.proving().runOn(ProvingThreads.background(SwingUtilities::invokeLater));
        desk.part("explanation", () -> window.explain(owner));
        desk.part("trade-page", window::browse);
    }

    private void explain(Component owner) {
        session.proving().explain(found -> ExplanationDialog.of(owner, found, session.language(), desk::copy)
                .setVisible(true));
    }

    /** Opens the page; without a browser, its path stays in the status line. */
    private void browse() {
        session.proving().trade().page().ifPresent(page -> {
            if (!isBrowsed(page)) {
                session.status(ProvingText.TRADE_DONE.words().with(page));
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
}
