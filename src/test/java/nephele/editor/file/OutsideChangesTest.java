package nephele.editor.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import nephele.editor.action.ActionCall;
import nephele.editor.action.Actions;
import nephele.editor.action.ScriptInterface;
import nephele.editor.save.Backups.Backup;
import nephele.editor.save.DraftLevel;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFile;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Whatever other programs do to the files of an open level, no version of it is lost. */
@Execution(ExecutionMode.CONCURRENT)
class OutsideChangesTest {
    private static final Level OPENED = DraftLevel.after(0);
    private static final Level MINE = DraftLevel.after(1);
    private static final Level THEIRS = DraftLevel.after(2);

    @TempDir
    Path folder;

    private final List<String> asked = new ArrayList<>();
    private final List<String> told = new ArrayList<>();
    private boolean isMineKept;
    private Path file;
    private EditorSession session;
    private OutsideChanges changes;

    @BeforeEach
    void open() {
        file = folder.resolve("room.json");
        session = FiledSession.of(folder, file, OPENED);
        changes = new OutsideChanges(session, this::isMineKept, message -> told.add(message.english()));
    }

    private boolean isMineKept(Words question) {
        asked.add(question.english());
        return isMineKept;
    }

    private void changedOutside(Level level) {
        LevelFile.save(file, level);
        changes.changed(Set.of(file));
    }

    private void save() {
        try {
            ActionCall call = new ActionCall(session, new ScriptInterface(() -> null), java.util.Map.of());
            Actions.named("save").orElseThrow().effect().run(call);
        } catch (EditorRefusal failure) {
            throw new AssertionError(failure);
        }
    }

    private List<Level> backups() {
        return session.fileServices().backups().of(file).stream()
                .map(Backup::file)
                .map(LevelFile::read)
                .toList();
    }

    @Test
    void aLevelWithoutChangesIsLoadedAgainSilently() {
        changedOutside(THEIRS);
        assertEquals(THEIRS, session.document().level());
        assertFalse(session.document().isModified());
        assertTrue(session.status().english().startsWith("room.json was changed by another program"));
        assertEquals(List.of(), asked);
        session.document().undo();
        assertEquals(OPENED, session.document().level());
        assertTrue(session.document().isModified());
    }

    @Test
    void mineCanBeKeptAndSavingMakesTheirsABackup() {
        FiledSession.edit(session, MINE);
        isMineKept = true;
        changedOutside(THEIRS);
        assertEquals(1, asked.size());
        assertEquals(MINE, session.document().level());
        assertTrue(session.document().isModified());
        save();
        assertEquals(MINE, LevelFile.read(file));
        assertEquals(List.of(THEIRS), backups());
        changes.changed(Set.of(file));
        assertEquals(1, asked.size(), "the session's own save is no change");
    }

    @Test
    void theirsCanBeLoadedAndMineIsABackupAndOneStepBack() {
        FiledSession.edit(session, MINE);
        changedOutside(THEIRS);
        assertEquals(THEIRS, session.document().level());
        assertFalse(session.document().isModified());
        assertEquals(List.of(MINE), backups());
        session.document().undo();
        assertEquals(MINE, session.document().level());
    }

    @Test
    void aDeletedFileIsToldOnceAndSaveWritesItAgain() throws IOException {
        Files.delete(file);
        changes.changed(Set.of(file));
        changes.changed(Set.of(file));
        assertEquals(1, told.size());
        assertTrue(told.get(0).contains(file.toString()) && told.get(0).contains("Save writes the file again"));
        assertEquals(OPENED, session.document().level());
        assertTrue(session.document().isModified(), "closing asks");
        assertEquals(List.of(OPENED), backups());
        save();
        assertEquals(OPENED, LevelFile.read(file));
        assertFalse(session.document().isModified());
    }

    @Test
    void aFileThatComesBackIsNoReasonToAsk() throws IOException {
        byte[] before = Files.readAllBytes(file);
        Files.delete(file);
        changes.changed(Set.of(file));
        Files.write(file, before);
        changes.changed(Set.of(file));
        assertFalse(session.document().isModified());
        Files.delete(file);
        changes.changed(Set.of(file));
        changedOutside(THEIRS);
        assertEquals(THEIRS, session.document().level());
        assertEquals(List.of(), asked);
        assertEquals(2, told.size());
    }

    @Test
    void aFileThatIsNoLevelChangesNothing() throws IOException {
        Files.writeString(file, "half a lev");
        changes.changed(Set.of(file));
        assertEquals(OPENED, session.document().level());
        assertTrue(session.status().english().contains("not to a level that can be read"));
        changedOutside(THEIRS);
        assertEquals(THEIRS, session.document().level());
    }

    @Test
    void aChangeWaitsForTheEndOfADrag() {
        session.document().drag(start -> start.with(MINE));
        changedOutside(THEIRS);
        assertEquals(MINE, session.document().level());
        session.document().cancelDrag();
        changes.settle();
        assertEquals(THEIRS, session.document().level());
    }

    @Test
    void aChangedAssetIsReadAgain() {
        AssetSource before = session.assets();
        changes.changed(Set.of(folder.resolve("brick.png")));
        assertNotSame(before, session.assets());
        assertEquals("Loaded again: brick.png", session.status().english());
        assertSame(OPENED.getClass(), session.document().level().getClass());
        assertFalse(session.document().isModified());
    }

    @Test
    void theWatchOfASessionFindsWhatChanges() throws Exception {
        LinkedBlockingQueue<Runnable> sessionThread = new LinkedBlockingQueue<>();
        SessionWatch watch = new SessionWatch(session, changes, sessionThread::add, Runnable::run);
        try {
            LevelFile.save(file, THEIRS);
            while (!session.document().level().equals(THEIRS)) {
                Runnable next = sessionThread.poll(60, TimeUnit.SECONDS);
                assertTrue(next != null, "the change is not told");
                next.run();
            }
        } finally {
            watch.close();
        }
    }
}
