package nephele.editor.start;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Clock;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import nephele.editor.action.ActionCall;
import nephele.editor.action.Actions;
import nephele.editor.play.PlayAnswer;
import nephele.editor.play.PlayText;
import nephele.editor.play.WarmGame;
import nephele.editor.save.journal.JournalFolder;
import nephele.editor.session.EditorFiles;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.session.SessionChange;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.editor.window.Closing;
import nephele.editor.window.EditorPanel;
import nephele.editor.window.EditorWindow;
import nephele.editor.window.SwingQuestions;
import nephele.editor.window.WindowInterface;
import nephele.editor.window.WindowLook;
import nephele.editor.window.dialog.ProvingWindow;
import nephele.editor.window.file.WindowFiles;

/** The editor with a window: its journal, the waiting game, and what happens when it closes. */
public final class WindowedEditing {
    private final EditorSession session;
    private final EditorFiles files;
    private final Consumer<String> report;
    private final WarmGame game;
    /** True if the play that goes on, or went on last, is to record a solution. */
    private volatile boolean isRecording;

    private WindowFiles work;
    private EditorWindow window;

    /**
     * @param gameLine the command line of the waiting game, for the file of the open level or {@code null}
     * @param report receives lines for the terminal
     */
    public WindowedEditing(
            EditorSession session, EditorFiles files, Supplier<List<String>> gameLine, Consumer<String> report) {
        this.session = session;
        this.files = files;
        this.report = report;
        game = new WarmGame(gameLine, this::follow);
    }

    /** Opens the window on the event dispatch thread; returns at once. */
    public void open(Runnable ended) {
        Thread.setDefaultUncaughtExceptionHandler(new FaultFile(files.fault(), this::tellFault));
        SwingUtilities.invokeLater(() -> {
            WindowLook.apply(session.settings());
            WindowInterface ui = new WindowInterface(session);
            EditorPanel panel = EditorParts.panel(session, ui, ui::part);
            ProvingWindow.connect(session, ui, panel);
            Closing closing = new Closing(session, new SwingQuestions(panel)::ask, () -> isSaved(ui));
            window = new EditorWindow(session, panel, ui, closing, () -> closed(ended));
            work = new WindowFiles(session, panel, window, ui, journals());
            session.playsWith(request -> {
                isRecording = request.record() != null;
                game.play(request);
            });
            session.listen(this::remember);
            remember(SessionChange.FILE);
            window.setVisible(true);
            work.offerLostWork();
            if (isFirstRoom()) {
                ui.show("guide");
            }
            SwingUtilities.invokeLater(game::warm);
        });
    }

    /** Keeps the settings as soon as they change, and the open file among the recent ones. */
    private void remember(SessionChange change) {
        if (change == SessionChange.SETTINGS) {
            keepSettings();
        }
        Optional<Path> file = change == SessionChange.FILE ? session.file().path() : Optional.empty();
        List<String> before = session.settings().get(EditorSetting.RECENT_FILES);
        file.map(session.settings()::withRecent)
                .filter(after -> !after.get(EditorSetting.RECENT_FILES).equals(before))
                .ifPresent(session::settings);
    }

    /** Returns true for a user with an empty level who has not left the guide yet. */
    private boolean isFirstRoom() {
        return !session.settings().get(EditorSetting.GUIDE_FINISHED)
                && session.file().path().isEmpty()
                && session.document().level().solids().isEmpty();
    }

    private JournalFolder journals() {
        return files.journals() != null ? new JournalFolder(files.journals(), Clock.systemUTC()) : null;
    }

    private boolean isSaved(WindowInterface ui) {
        try {
            Actions.named("save").orElseThrow().run(new ActionCall(session, ui, java.util.Map.of()));
        } catch (EditorRefusal failure) {
            session.status(failure.words());
        }
        return !session.document().isModified();
    }

    private void closed(Runnable ended) {
        game.close();
        work.close();
        session.proving().close();
        keepSettings();
        // The process must not end while its drawing thread is in the driver.
        window.panel().viewport().surface().closed().whenComplete((nothing, failed) -> ended.run());
    }

    private void keepSettings() {
        try {
            files.save(session.settings());
        } catch (IOException problem) {
            report.accept(problem.getMessage());
        }
    }

    /** Follows the waiting game; that it waits is no news for the user. */
    private void follow(PlayAnswer answer) {
        if (answer instanceof PlayAnswer.Playing) {
            tell(PlayText.PLAYING.words());
        } else if (answer instanceof PlayAnswer.Baking baking) {
            tell(PlayText.BAKING.with(baking.percent()));
        } else if (answer instanceof PlayAnswer.Failed failed) {
            tell(Words.same(failed.message()));
        } else if (answer instanceof PlayAnswer.Ended ended) {
            tell(isRecording ? PlayText.ofRecording(ended.end()) : PlayText.of(ended.end()));
            // Not every window system gives the keyboard back by itself.
            SwingUtilities.invokeLater(window::takeKeyboard);
        }
    }

    private void tellFault(Words words) {
        report.accept(words.english());
        tell(words);
    }

    private void tell(Words words) {
        SwingUtilities.invokeLater(() -> session.status(words));
    }
}
