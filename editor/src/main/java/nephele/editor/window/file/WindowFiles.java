package nephele.editor.window.file;

import java.awt.Dialog;
import java.awt.Window;
import java.time.Instant;
import java.time.ZoneId;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.SwingUtilities;
import nephele.editor.file.BackupList;
import nephele.editor.file.FileText;
import nephele.editor.file.OutsideChanges;
import nephele.editor.file.RecoveryList;
import nephele.editor.file.SessionJournal;
import nephele.editor.file.SessionWatch;
import nephele.editor.save.journal.JournalFolder;
import nephele.editor.save.journal.RecoverableWork;
import nephele.editor.session.EditorSession;
import nephele.editor.text.Words;
import nephele.editor.window.EditorPanel;
import nephele.editor.window.SwingQuestions;
import nephele.editor.window.WindowInterface;
import nephele.engine.level.Language;

/**
 * The life of files in a window: edits are journalled, lost work is offered, changes on disk are followed, files can be
 * dropped. It is used by the event dispatch thread.
 */
public final class WindowFiles implements AutoCloseable {
    private final EditorSession session;
    private final Window window;
    private final WindowInterface ui;
    private final SwingQuestions questions;
    private final SessionJournal journal;
    private final JournalPictures pictures;
    private final SessionWatch watch;
    private final ExecutorService background = Executors.newSingleThreadExecutor(work -> {
        Thread thread = new Thread(work, "nephele-files");
        thread.setDaemon(true);
        return thread;
    });

    /**
     * Begins to follow a session.
     *
     * @param journals of this process; {@code null} if edits are not to be recorded
     */
    public WindowFiles(
            EditorSession session, EditorPanel panel, Window window, WindowInterface ui, JournalFolder journals) {
        this.session = session;
        this.window = window;
        this.ui = ui;
        questions = new SwingQuestions(window);
        journal = journals == null ? null : new SessionJournal(session, journals, this::reportSoon);
        pictures =
                journal == null ? null : new JournalPictures(session, panel.viewport(), background, journal::picture);
        var changes = new OutsideChanges(session, this::isMineKept, this::warn);
        watch = new SessionWatch(session, changes, SwingUtilities::invokeLater, background);
        var drops = new FileDrops(session, panel.viewport(), this::mayLeave, this::report, ui::sceneUse);
        drops.accept(panel);
        drops.accept(panel.viewport().surface().component());
        ui.part("backups", this::showBackups);
        ui.part("recover", () -> findLost(true));
    }

    /** Looks for lost work beside the opening window, and offers it if there is some. */
    public void offerLostWork() {
        findLost(false);
    }

    private void reportSoon(Words words) {
        SwingUtilities.invokeLater(() -> session.status(words));
    }

    private boolean mayLeave() {
        return !session.document().isModified() || ui.isAgreed(FileText.LOSES.words());
    }

    private void report(Words message) {
        session.status(message);
        warn(message);
    }

    private void warn(Words message) {
        questions.warn(message.in(session.language()), session.language());
    }

    private boolean isMineKept(Words question) {
        Language language = session.language();
        // A dialogue that is closed loads nothing: the user's own version is the safe answer.
        int chosen = questions.choice(
                question.in(language), language, FileText.KEEP_MINE.in(language), FileText.LOAD_THEIRS.in(language));
        return chosen != 1;
    }

    /** Reads the journals in the background: the window does not wait for them. */
    private void findLost(boolean isAsked) {
        if (journal == null) {
            return;
        }
        background.execute(() -> {
            List<RecoverableWork> works = journal.lost();
            SwingUtilities.invokeLater(() -> offer(works, isAsked));
        });
    }

    private void offer(List<RecoverableWork> works, boolean isAsked) {
        if (works.isEmpty()) {
            if (isAsked) {
                session.status(FileDialogText.NOTHING_LOST.words());
            }
            return;
        }
        RecoveryList lost = new RecoveryList(journal, works, Instant.now(), ZoneId.systemDefault());
        JDialog dialog = dialog(FileDialogText.RECOVER_TITLE.in(session.language()));
        RecoveryPanel panel =
                new RecoveryPanel(lost, session.language(), ui::isAgreed, this::mayLeave, dialog::dispose);
        show(dialog, panel, panel.recoverButton(), panel.rows());
    }

    private void showBackups() {
        JDialog dialog = dialog(FileDialogText.BACKUPS_TITLE
                .with(session.file().path().orElseThrow().getFileName())
                .in(session.language()));
        BackupsPanel panel = new BackupsPanel(
                new BackupList(session, Instant.now(), ZoneId.systemDefault()),
                session.language(),
                this::mayLeave,
                this::report,
                dialog::dispose);
        show(dialog, panel, panel.restoreButton(), panel.rows());
    }

    private JDialog dialog(String title) {
        return new JDialog(window, title, Dialog.ModalityType.APPLICATION_MODAL);
    }

    private void show(JDialog dialog, JComponent content, JButton main, JComponent first) {
        dialog.setDefaultCloseOperation(JDialog.DISPOSE_ON_CLOSE);
        dialog.add(content);
        dialog.getRootPane().setDefaultButton(main);
        dialog.pack();
        dialog.setMinimumSize(dialog.getSize());
        dialog.setLocationRelativeTo(window);
        first.requestFocusInWindow();
        dialog.setVisible(true);
    }

    /** Ends it; unsaved work that the user has left is not offered again. */
    @Override
    public void close() {
        watch.close();
        if (journal != null) {
            pictures.close();
            journal.close();
            session.maps().discard();
        }
        background.shutdown();
    }
}
