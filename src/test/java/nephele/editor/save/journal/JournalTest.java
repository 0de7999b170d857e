package nephele.editor.save.journal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import nephele.app.ChildJvm;
import nephele.editor.save.DocumentFile;
import nephele.editor.save.DraftLevel;
import nephele.editor.text.Words;
import nephele.engine.level.Language;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelJson;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Every edit is found again after a crash, and nothing is offered that nobody lost. */
@Execution(ExecutionMode.CONCURRENT)
class JournalTest {
    private static final Instant NOW = Instant.parse("2026-01-02T03:04:05Z");

    @TempDir
    Path folder;

    private int crashes;

    private Path journals() {
        return folder.resolve("journal");
    }

    private JournalFolder editor() {
        return new JournalFolder(journals(), InstantSource.fixed(NOW));
    }

    private Journal untitled(JournalFolder editor) {
        return editor.open(DocumentFile.UNTITLED, "new level", DraftLevel.after(0), JournalListener.NONE);
    }

    private JournalFolder crashed() throws IOException {
        return CrashedEditor.copy(journals(), folder.resolve("crash-" + crashes++));
    }

    private List<RecoverableWork> recoverable() throws IOException {
        return crashed().find().works();
    }

    private static void edit(Journal journal, int edits) {
        journal.record("move " + edits, DraftLevel.after(edits));
        assertTrue(journal.flush());
    }

    private static List<Path> in(Path folder) throws IOException {
        try (var all = Files.list(folder)) {
            return all.toList();
        }
    }

    @Test
    void workThatWasNeverSavedIsRecovered() throws IOException {
        JournalFolder editor = editor();
        try (Journal journal = untitled(editor)) {
            assertTrue(journal.flush());
            assertFalse(Files.exists(journals()), "nothing is written before the first edit");
            edit(journal, 1);
            edit(journal, 2);
            journal.picture(new byte[] {1, 2, 3});
            assertTrue(journal.flush());
            RecoverableWork work = recoverable().get(0);
            assertEquals("new level", work.title());
            assertEquals(Optional.empty(), work.file().path());
            assertEquals(DraftLevel.after(2), work.level());
            assertEquals(DraftLevel.after(0), work.saved());
            assertEquals(NOW, work.lastEdit());
            assertEquals(2, work.edits());
            assertEquals("move 2", work.lastLabel());
            assertArrayEquals(
                    new byte[] {1, 2, 3}, Files.readAllBytes(work.picture().orElseThrow()));
            assertEquals(List.of(), editor.find().works(), "the editor's own journal is not offered");
        }
    }

    @Test
    void statesInBetweenCostNothingButAreCounted() throws IOException {
        try (Journal journal = untitled(editor())) {
            for (int i = 1; i <= 1000; i++) {
                journal.record("drag", DraftLevel.after(i));
            }
            assertTrue(journal.flush());
            RecoverableWork work = recoverable().get(0);
            assertEquals(1000, work.edits());
            assertEquals(DraftLevel.after(1000), work.level());
        }
    }

    @Test
    void whatIsSavedIsNotOffered() throws IOException {
        Path level = folder.resolve("a.json");
        LevelFile.save(level, DraftLevel.after(0));
        DocumentFile file = DocumentFile.open(level.toString()).file();
        try (Journal journal = editor().open(file, "a.json", DraftLevel.after(0), JournalListener.NONE)) {
            edit(journal, 1);
            assertEquals(file, recoverable().get(0).file());
            LevelFile.save(level, DraftLevel.after(1));
            assertEquals(List.of(), recoverable(), "killed after the save, before it was noted");
            Level saved = DraftLevel.after(1);
            Path other = folder.resolve("b.json");
            LevelFile.save(other, saved);
            DocumentFile now = DocumentFile.open(other.toString()).file();
            journal.record("move 1", saved);
            journal.saved(now, saved);
            assertTrue(journal.flush());
            assertEquals(List.of(), recoverable());
            edit(journal, 2);
            RecoverableWork work = recoverable().get(0);
            assertEquals(now, work.file());
            assertEquals("b.json", work.title());
            assertEquals(1, work.edits());
            assertEquals(saved, work.saved());
            edit(journal, 1);
            assertEquals(List.of(), recoverable(), "undone until nothing is unsaved");
        }
        assertEquals(List.of(), in(journals()));
    }

    @Test
    void anEditMadeWhileTheLevelWasBeingSavedStaysUnsaved() throws IOException {
        try (Journal journal = untitled(editor())) {
            Level saving = DraftLevel.after(1);
            journal.record("move 1", saving);
            journal.record("move 2", DraftLevel.after(2));
            Path level = folder.resolve("a.json");
            LevelFile.save(level, saving);
            journal.saved(DocumentFile.open(level.toString()).file(), saving);
            assertTrue(journal.flush());
            assertEquals(DraftLevel.after(2), recoverable().get(0).level());
        }
    }

    @Test
    void closingKeepsWhatIsUnsavedAndDiscardingNothing() throws IOException {
        Journal kept = untitled(editor());
        kept.record("move", DraftLevel.after(1));
        kept.close();
        JournalFolder next = editor();
        RecoverableWork work = next.find().works().get(0);
        assertEquals(DraftLevel.after(1), work.level());
        next.discard(work);
        assertEquals(List.of(), in(journals()));
        Journal discarded = untitled(next);
        edit(discarded, 1);
        discarded.discard();
        assertEquals(List.of(), in(journals()));
    }

    @Test
    void resumedWorkIsNeverWithoutAJournal() throws IOException {
        Journal first = untitled(editor());
        edit(first, 1);
        edit(first, 2);
        first.close();
        JournalFolder next = editor();
        try (Journal resumed = next.resume(next.find().works().get(0), JournalListener.NONE)) {
            assertEquals(2, recoverable().get(0).edits());
            assertEquals(1, in(journals()).size());
            edit(resumed, 3);
            RecoverableWork work = recoverable().get(0);
            assertEquals(3, work.edits());
            assertEquals(DraftLevel.after(0), work.saved());
        }
    }

    @Test
    void aFullDiskIsToldOnceAndCostsNothingAfterwards() throws IOException {
        Path place = journals().resolve("x");
        var store = new FaultyStore(new StoredJournal(place));
        List<Words> told = new CopyOnWriteArrayList<>();
        var origin = new JournalLog.Origin("t", DocumentFile.UNTITLED, DraftLevel.after(0), NOW);
        try (Journal journal = new Journal(place, store, origin, told::add, InstantSource.fixed(NOW), () -> {})) {
            edit(journal, 1);
            store.full(true);
            for (int i = 2; i <= 4; i++) {
                journal.record("move", DraftLevel.after(i));
                assertFalse(journal.flush());
                assertEquals(DraftLevel.after(1), recoverable().get(0).level(), "half a record is ignored");
            }
            assertEquals(1, told.size());
            String message = told.get(0).in(Language.EN);
            assertTrue(message.contains(place.toString()) && message.contains("the disk is full"), message);
            store.full(false);
            assertTrue(journal.flush());
            assertEquals(DraftLevel.after(4), recoverable().get(0).level());
            edit(journal, 5);
            assertEquals(DraftLevel.after(5), recoverable().get(0).level());
        }
    }

    @Test
    void aFlushDoesNotFailWithAWriteThatBeganBeforeIt() throws Exception {
        Path place = journals().resolve("x");
        var store = new FaultyStore(new StoredJournal(place));
        var origin = new JournalLog.Origin("t", DocumentFile.UNTITLED, DraftLevel.after(0), NOW);
        try (Journal journal =
                new Journal(place, store, origin, JournalListener.NONE, InstantSource.fixed(NOW), () -> {})) {
            var flush = new FutureTask<>(journal::flush);
            store.full(true);
            store.onRefusal(() -> {
                Thread flushing = new Thread(flush);
                flushing.start();
                while (flushing.getState() != Thread.State.WAITING) {
                    Thread.onSpinWait();
                }
                store.full(false);
            });
            journal.record("move", DraftLevel.after(1));
            assertTrue(flush.get(60, TimeUnit.SECONDS));
            assertEquals(DraftLevel.after(1), recoverable().get(0).level());
        }
    }

    @Test
    void aDeletedJournalIsWrittenAgain() throws IOException {
        try (Journal journal = untitled(editor())) {
            edit(journal, 1);
            Files.delete(new StoredJournal(in(journals()).get(0)).log());
            journal.record("move", DraftLevel.after(2));
            journal.flush();
            assertTrue(journal.flush());
            assertEquals(DraftLevel.after(2), recoverable().get(0).level());
        }
    }

    @Test
    void aDamagedJournalIsKeptAndLitterIsNot() throws IOException {
        Path damaged = Files.createDirectories(journals().resolve("damaged"));
        Files.writeString(new StoredJournal(damaged).log(), "no log");
        Path fresh = Files.createDirectories(journals().resolve("fresh"));
        Path litter = Files.createDirectories(journals().resolve("litter"));
        Files.setLastModifiedTime(litter, java.nio.file.attribute.FileTime.from(NOW.minusSeconds(100_000)));
        JournalFolder.Findings found = editor().find();
        assertEquals(List.of(damaged), found.unreadable());
        assertEquals(List.of(), found.works());
        assertTrue(Files.exists(damaged) && Files.exists(fresh));
        assertFalse(Files.exists(litter));
    }

    /** Prints how many works another process finds. */
    public static void main(String[] arguments) {
        var found = new JournalFolder(Path.of(arguments[0]), InstantSource.system()).find();
        System.out.print(found.works().size());
    }

    @Test
    void theJournalOfALivingEditorIsNotOfferedByAnotherOne() throws Exception {
        Journal journal = untitled(editor());
        edit(journal, 1);
        assertEquals(
                "0",
                ChildJvm.run(
                                folder,
                                Map.of(),
                                JournalTest.class.getName(),
                                journals().toString())
                        .out());
        journal.close();
        assertEquals(1, editor().find().works().size());
    }

    @Test
    void aStateThatIsNoLevelCostsOnlyItself() throws IOException {
        List<Words> told = new CopyOnWriteArrayList<>();
        try (Journal journal = editor().open(DocumentFile.UNTITLED, "t", DraftLevel.after(0), told::add)) {
            edit(journal, 1);
            String tooLong = "x".repeat(1000);
            Level bad = Level.of(tooLong, "", DraftLevel.after(0).environment(), List.of());
            journal.record("bad", bad);
            journal.flush();
            RecoverableWork work = recoverable().get(0);
            assertEquals(LevelJson.write(DraftLevel.after(1)), LevelJson.write(work.level()));
        }
    }
}
