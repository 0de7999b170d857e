package nephele.editor.session;

import java.nio.file.Path;
import java.util.Optional;
import nephele.editor.document.BackgroundReading;
import nephele.editor.document.Selection;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneLayout;
import nephele.editor.proving.ProvingSubject;
import nephele.editor.session.SessionListener.Change;
import nephele.editor.text.Words;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Language;
import nephele.engine.level.Level;

/** The session as its proofs see it. */
record ProvedSession(EditorSession session) implements ProvingSubject {
    @Override
    public Level level() {
        return session.document().level();
    }

    @Override
    public AssetSource assets() {
        return session.assets();
    }

    @Override
    public BackgroundReading background() {
        return session.background();
    }

    @Override
    public Optional<Path> file() {
        return session.file().path();
    }

    @Override
    public Selection selection() {
        return session.document().selection();
    }

    @Override
    public boolean isSettled() {
        return !session.document().isDragging();
    }

    @Override
    public PaneLayout panes() {
        return session.panes();
    }

    @Override
    public void panes(PaneLayout panes) {
        session.panes(before -> panes);
    }

    @Override
    public PaneSize viewport() {
        return session.viewport();
    }

    @Override
    public Language language() {
        return session.language();
    }

    @Override
    public void status(Words words) {
        session.status(words);
    }

    @Override
    public void redraw() {
        session.tell(Change.VIEW);
    }
}
