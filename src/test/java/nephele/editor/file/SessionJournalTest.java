package nephele.editor.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import nephele.editor.save.DraftLevel;
import nephele.editor.save.journal.CrashedEditor;
import nephele.editor.save.journal.JournalFolder;
import nephele.editor.save.journal.RecoverableWork;
import nephele.editor.session.EditorSession;
import nephele.editor.text.Words;
import nephele.engine.level.Language;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** A session's work survives its crash, and is offered to the next session. */
@Execution(ExecutionMode.CONCURRENT)
class SessionJournalTest {
    private static final Instant NOW = Instant.parse("2026-01-02T14:02:05Z");
    private static final ZoneId ZONE = ZoneOffset.UTC;

    @TempDir
    Path folder;

    private final List<Words> troubles = new ArrayList<>();

    private JournalFolder journals(String name) {
        return new JournalFolder(folder.resolve(name), InstantSource.fixed(NOW));
    }

    private SessionJournal journal(EditorSession session, JournalFolder journals) {
        return new SessionJournal(session, journals, troubles::add);
    }

    private static RecoveryList offer(SessionJournal journal, Instant now) {
        return new RecoveryList(journal, journal.lost(), now, ZONE);
    }

    /** Leaves what a killed editor leaves after some edits. */
    private JournalFolder crashed(EditorSession session, int edits) throws IOException {
        SessionJournal journal = journal(session, journals("running"));
        for (int i = 1; i <= edits; i++) {
            FiledSession.edit(session, DraftLevel.after(i));
        }
        assertTrue(journal.flush());
        JournalFolder left = CrashedEditor.copy(folder.resolve("running"), folder.resolve("left"));
        journal.close();
        return left;
    }

    @Test
    void whatAKilledEditorLeavesIsOfferedAndRecoveredAsUnsavedWork() throws IOException {
        Path file = folder.resolve("room.json");
        JournalFolder left = crashed(FiledSession.of(folder, file, DraftLevel.after(0)), 3);
        EditorSession session = FiledSession.untitled(folder);
        SessionJournal journal = journal(session, left);
        RecoveryList offered = offer(journal, NOW.plus(Duration.ofHours(2)));
        FileRow row = offered.rows().get(0);
        assertEquals("room.json", row.title().english());
        assertEquals("today 14:02 · 3 edits · last: edit", row.detail().english());
        assertEquals("hoje, 14:02 · 3 edições · última: edit", row.detail().in(Language.PT_PT));
        assertEquals(file.toString(), row.place().english());
        offered.recover(0);
        assertEquals(DraftLevel.after(3), session.document().level());
        assertTrue(session.document().isModified());
        assertEquals(file, session.file().path().orElseThrow());
        assertTrue(offered.works().isEmpty());

        FiledSession.edit(session, DraftLevel.after(4));
        assertTrue(journal.flush());
        List<RecoverableWork> again = CrashedEditor.copy(folder.resolve("left"), folder.resolve("again"))
                .find()
                .works();
        assertEquals(1, again.size(), "one journal goes on, the old one is gone");
        assertEquals(4, again.get(0).edits());
        assertEquals(DraftLevel.after(4), again.get(0).level());
        session.document().undo();
        session.document().undo();
        assertEquals(DraftLevel.after(0), session.document().level());
        assertFalse(session.document().isModified(), "undo returns to what is on disk");
        journal.close();
        assertEquals(List.of(), troubles);
    }

    @Test
    void workThatWasNeverSavedIsOfferedToo() throws IOException {
        JournalFolder left = crashed(FiledSession.untitled(folder), 1);
        EditorSession session = FiledSession.untitled(folder);
        SessionJournal journal = journal(session, left);
        RecoveryList offered = offer(journal, NOW.plus(Duration.ofDays(1)));
        assertEquals("draft", offered.rows().get(0).title().english());
        assertEquals(
                "yesterday 14:02 · 1 edit · last: edit",
                offered.rows().get(0).detail().english());
        offered.recover(0);
        assertEquals(DraftLevel.after(1), session.document().level());
        assertTrue(session.file().path().isEmpty());
        journal.close();
    }

    @Test
    void aRunningSessionIsNotOfferedAndDiscardedWorkNeverAgain() throws IOException {
        EditorSession running = FiledSession.untitled(folder);
        SessionJournal own = journal(running, journals("running"));
        FiledSession.edit(running, DraftLevel.after(1));
        assertTrue(own.flush());
        EditorSession other = FiledSession.untitled(folder);
        SessionJournal journal = journal(other, journals("running"));
        assertEquals(List.of(), journal.lost());
        own.leave();
        RecoveryList offered = offer(journal, NOW);
        assertEquals(1, offered.rows().size());
        offered.discard(0);
        assertEquals(List.of(), journal.lost());
        journal.close();
    }

    @Test
    void knowingOfAnotherVersionOnDiskKeepsTheJournal() {
        EditorSession session = FiledSession.of(folder, folder.resolve("a.json"), DraftLevel.after(0));
        SessionJournal journal = journal(session, journals("running"));
        session.document().markUnsaved();
        FiledSession.edit(session, DraftLevel.after(1));
        session.known(session.file().asOfNow());
        journal.leave();
        assertEquals(1, journals("running").find().works().size());
    }

    @Test
    void olderTimesAreWrittenOut() {
        Words then = FileText.time(NOW, NOW.plus(Duration.ofDays(9)), ZONE);
        assertEquals("2 January 2026, 14:02", then.english());
        assertEquals("2 de janeiro de 2026, 14:02", then.brazilian());
    }
}
