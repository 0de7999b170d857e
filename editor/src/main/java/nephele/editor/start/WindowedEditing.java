package nephele.editor.start;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Clock;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import nephele.editor.action.ActionCall;
import nephele.editor.action.ActionFailure;
import nephele.editor.action.Actions;
import nephele.editor.document.Document;
import nephele.editor.play.PlayEnd;
import nephele.editor.play.PlayText;
import nephele.editor.play.WarmGame;
import nephele.editor.save.journal.Journal;
import nephele.editor.save.journal.JournalFolder;
import nephele.editor.save.journal.JournalListener;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionListener.Change;
import nephele.editor.settings.EditorFiles;
import nephele.editor.surface.SurfaceMode;
import nephele.editor.text.Words;
import nephele.editor.window.Closing;
import nephele.editor.window.EditorPanel;
import nephele.editor.window.EditorWindow;
import nephele.editor.window.WindowDesk;
import nephele.editor.window.WindowLook;

/** The editor with a window: its journal, the waiting game, and what happens when it closes. */
public final class WindowedEditing {
    private final EditorSession session;
    private final EditorFiles files;
    private final Consumer<String> report;
    private final JournalFolder journals;
    private final WarmGame game;
    private Journal journal;

    /**
     * @param gameLine the command line of the waiting game, for the file of the open level or {@code null}
     * @param report receives lines for the terminal
     */
    public WindowedEditing(
            EditorSession session, EditorFiles files, Supplier<List<String>> gameLine, Consumer<String> report) {
        this.session = session;
        this.files = files;
        this.report = report;
        journals = files.journals() == null ? null : new JournalFolder(files.journals(), Clock.systemUTC());
        game = new WarmGame(gameLine, new Told());
    }

    /** Opens the window on the event dispatch thread; returns at once. */
    public void open(SurfaceMode surface, Runnable ended) {
        SwingUtilities.invokeLater(() -> {
            WindowLook.apply(session.settings());
            WindowDesk desk = new WindowDesk(session);
            EditorPanel panel = EditorParts.panel(session, desk, surface);
            Closing closing = new Closing(session, EditorWindow.question(panel), () -> isSaved(desk));
            EditorWindow window = new EditorWindow(session, panel, desk, closing, () -> closed(ended));
            openJournal();
            session.document().listen((before, after) -> record(session.document()));
            session.listen(this::follow);
            session.playsWith(game::play);
            window.setVisible(true);
            SwingUtilities.invokeLater(game::warm);
        });
    }

    private void openJournal() {
        if (journals != null) {
            journal = journals.open(session.file(), title(), session.document().level(), new JournalTrouble());
        }
    }

    private String title() {
        return session.file().path().map(Path::getFileName).map(Path::toString).orElse("untitled");
    }

    private void record(Document document) {
        if (journal != null && !document.isDragging() && document.isModified()) {
            Words label = document.history().undoLabel().orElse(Words.NONE);
            journal.record(label.english(), document.level());
        }
    }

    private void follow(Change change) {
        if (change != Change.FILE || journal == null) {
            return;
        }
        if (session.document().history().position() == 0) {
            journal.discard();
            openJournal();
        } else if (!session.document().isModified()) {
            journal.saved(session.file(), session.document().level());
        }
    }

    private boolean isSaved(WindowDesk desk) {
        try {
            Actions.named("save").orElseThrow().effect().run(new ActionCall(session, desk, java.util.Map.of()));
        } catch (ActionFailure failure) {
            session.status(failure.told());
        }
        return !session.document().isModified();
    }

    private void closed(Runnable ended) {
        game.close();
        if (journal != null) {
            journal.discard();
        }
        try {
            files.save(session.settings());
        } catch (IOException problem) {
            report.accept(problem.getMessage());
        }
        ended.run();
    }

    /** Tells of a journal that cannot be written; the work itself is not in danger yet. */
    private final class JournalTrouble implements JournalListener {
        @Override
        public void failed(Words message) {
            tell(message);
        }

        @Override
        public void recorded(long number) {
            // The status bar has more important things to say.
        }
    }

    /** Tells what happens to the game. */
    private final class Told implements WarmGame.Listener {
        @Override
        public void ready() {
            // Nothing to tell: it is only sooner next time.
        }

        @Override
        public void playing(long millis) {
            tell(PlayText.PLAYING.words());
        }

        @Override
        public void baking(int percent) {
            tell(PlayText.BAKING.with(percent));
        }

        @Override
        public void ended(PlayEnd end) {
            tell(PlayText.of(end));
        }

        @Override
        public void failed(String message) {
            tell(Words.same(message));
        }
    }

    private void tell(Words words) {
        SwingUtilities.invokeLater(() -> session.status(words));
    }
}
