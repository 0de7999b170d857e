package nephele.editor.file;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import nephele.editor.document.Document;
import nephele.editor.document.History;
import nephele.editor.document.Registration;
import nephele.editor.save.journal.Journal;
import nephele.editor.save.journal.JournalFolder;
import nephele.editor.save.journal.JournalListener;
import nephele.editor.save.journal.RecoverableWork;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionChange;
import nephele.editor.text.Words;
import nephele.engine.asset.LevelAssets;

/** Records a session's edits in a journal, and takes up work that another session has lost. */
public final class SessionJournal implements AutoCloseable {
    private final EditorSession session;
    private final JournalFolder journals;
    private final JournalListener listener;
    private final List<Registration> registrations;
    private Journal journal;
    /** The history of the document that the journal belongs to; another document has another one. */
    private History history;
    /** True while recovered work, which its journal has already, is put into the session. */
    private boolean isRecovering;

    /**
     * Begins to record.
     *
     * @param trouble told on the journal's thread when edits can't be recorded
     */
    public SessionJournal(EditorSession session, JournalFolder journals, Consumer<Words> trouble) {
        this.session = session;
        this.journals = journals;
        listener = message -> trouble.accept(message);
        begin();
        registrations = List.of(session.document().listen((before, after) -> record()), session.listen(this::follow));
    }

    private void begin() {
        String title =
                session.file().path().map(Path::getFileName).map(Path::toString).orElse("");
        history = session.document().history();
        journal = journals.open(session.file(), title, session.document().level(), listener);
    }

    private void record() {
        Document document = session.document();
        if (isRecovering || document.history() != history || document.isDragging() || !document.isModified()) {
            return;
        }
        Words label = document.history().undoLabel().orElse(Words.NONE);
        journal.record(label.english(), document.level());
    }

    private void follow(SessionChange change) {
        if (change != SessionChange.FILE || isRecovering) {
            return;
        }
        if (session.document().history() != history) {
            journal.discard();
            begin();
        } else if (!session.document().isModified()) {
            journal.saved(session.file(), session.document().level());
        }
    }

    /** Finds the work of sessions that have ended without saving; may be called on any thread. */
    public List<RecoverableWork> lost() {
        return journals.find().works();
    }

    /** Opens lost work as a modified document of its file; its journal goes on. What was open before is left. */
    public void recover(RecoverableWork work) {
        Journal left = journal;
        journal = journals.resume(work, listener);
        isRecovering = true;
        LevelAssets assets = LevelAssets.beside(work.file().path().orElse(Path.of("untitled.json")));
        session.open(work.file(), work.saved(), assets);
        session.document().edit(FileText.RECOVERED.words(), level -> work.level());
        history = session.document().history();
        isRecovering = false;
        left.discard();
        session.status(FileText.RECOVERED_STATUS.with(titleOf(work)));
    }

    private static String titleOf(RecoverableWork work) {
        return work.file()
                .path()
                .map(path -> path.getFileName().toString())
                .orElse(work.level().name());
    }

    /** Deletes lost work that its user does not want. */
    public void discard(RecoverableWork work) {
        journals.discard(work);
    }

    /** Keeps a small picture of the document for the offer to recover it. */
    public void picture(byte[] png) {
        journal.picture(png);
    }

    /** Writes everything at once and waits for it; returns false if that failed. */
    boolean flush() {
        return journal.flush();
    }

    /** Ends the journal; what is unsaved stays on disk and is offered at the next start. */
    public void leave() {
        registrations.forEach(Registration::close);
        journal.close();
    }

    /** Ends the journal and deletes it, because its user has saved or does not want what is unsaved. */
    @Override
    public void close() {
        registrations.forEach(Registration::close);
        journal.discard();
    }
}
