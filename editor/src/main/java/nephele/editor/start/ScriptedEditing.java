package nephele.editor.start;

import java.awt.Dimension;
import java.util.List;
import java.util.Optional;
import nephele.editor.action.ScriptInterface;
import nephele.editor.action.ScriptRunner;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
import nephele.editor.window.EditorPanel;
import nephele.editor.window.WindowLook;

/** Runs a script on a level without a display. */
public final class ScriptedEditing {
    private static final Dimension SIZE = new Dimension(1280, 800);
    /** The size of the viewport in a picture of the whole editor. */
    private static final PaneSize VIEWPORT = new PaneSize(770, 560);

    private final EditorSession session;

    public ScriptedEditing(EditorSession session) {
        this.session = session;
        session.viewport(VIEWPORT);
    }

    /** Runs the lines in order and ends the session; returns the failed one as {@code LINE: reason}, or empty. */
    public Optional<String> run(List<String> lines) {
        ScriptInterface ui = new ScriptInterface(this::picture);
        ScriptRunner script = new ScriptRunner(session, ui);
        for (int i = 0; i < lines.size() && !ui.isEnded(); i++) {
            try {
                script.run(lines.get(i));
            } catch (EditorRefusal failure) {
                session.maps().discard();
                return Optional.of((i + 1) + ": " + failure.words().in(session.language()));
            }
        }
        session.maps().discard();
        return Optional.empty();
    }

    /** Draws the whole editor as its window would show it. */
    private java.awt.image.BufferedImage picture() {
        WindowLook.apply(session.settings());
        try (EditorPanel panel = EditorParts.panel(session, new ScriptInterface(() -> null), (part, opener) -> {})) {
            panel.layOut(SIZE);
            return panel.picture();
        }
    }
}
