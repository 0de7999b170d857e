package nephele.editor.save;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import nephele.engine.level.Language;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The last 50 versions of a file are kept, whatever the clock says. */
@Execution(ExecutionMode.CONCURRENT)
class BackupsTest {
    private static final Instant NOW = Instant.parse("2026-01-02T03:04:05.678Z");

    @TempDir
    Path folder;

    private Backups backups() {
        return new Backups(folder.resolve("backups"), InstantSource.fixed(NOW));
    }

    @Test
    void theNewestFiftyAreKept() throws IOException {
        Path file = folder.resolve("a.json");
        for (int i = 0; i < 60; i++) {
            Files.writeString(file, "version " + i);
            assertTrue(backups().keep(file).isEmpty());
        }
        List<Backups.Backup> kept = backups().of(file);
        assertEquals(Backups.MOST, kept.size());
        for (int i = 0; i < Backups.MOST; i++) {
            assertEquals("version " + (59 - i), Files.readString(kept.get(i).file()));
        }
        assertEquals(NOW.plusMillis(59), kept.get(0).replaced());
    }

    @Test
    void theSameContentIsKeptOnceAndFilesOfOneNameApart() throws IOException {
        Path file = folder.resolve("a.json");
        Path other = Files.createDirectory(folder.resolve("other")).resolve("a.json");
        Files.writeString(file, "one");
        Files.writeString(other, "two");
        backups().keep(file);
        backups().keep(file);
        backups().keep(other);
        backups().keep(folder.resolve("missing.json"));
        assertEquals(1, backups().of(file).size());
        assertEquals(1, backups().of(other).size());
        assertEquals(List.of(), backups().of(folder.resolve("missing.json")));
    }

    @Test
    void aBackupThatFailsIsNoticedAndTheLevelSaved() throws IOException {
        Files.writeString(folder.resolve("backups"), "a file where the folder should be");
        Path file = folder.resolve("a.json");
        var saver = new DocumentSaver(backups());
        saver.saveAs(file, DraftLevel.after(0));
        var saved = (SaveResult.Saved) saver.saveAs(file, DraftLevel.after(1));
        String notice = saved.notices().get(0).in(Language.EN);
        assertTrue(notice.contains(folder.resolve("backups").toString()), notice);
    }
}
