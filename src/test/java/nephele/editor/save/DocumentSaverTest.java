package nephele.editor.save;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.InstantSource;
import java.util.List;
import nephele.engine.level.FaultyFiles;
import nephele.engine.level.Level;
import nephele.engine.level.json.FileOperations;
import nephele.engine.level.json.LevelFile;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** A save succeeds, or says why and what to do; what is on disk is the old or the new version. */
@Execution(ExecutionMode.CONCURRENT)
class DocumentSaverTest {
    private static final Level OLD = DraftLevel.after(0);
    private static final Level NEW = DraftLevel.after(1);

    @TempDir
    Path folder;

    private Path path;
    private DocumentFile file;

    @BeforeEach
    void saveTheOldVersion() throws IOException {
        Path levels = Files.createDirectory(folder.resolve("levels"));
        path = levels.resolve("a.json");
        LevelFile.save(path, OLD);
        file = DocumentFile.open(path.toString()).file();
    }

    private DocumentSaver saver(FileOperations operations) {
        return new DocumentSaver(new Backups(folder.resolve("backups"), InstantSource.system()), operations);
    }

    private SaveResult save() {
        return saver(FileOperations.REAL).save(file, NEW);
    }

    private void assertFailed(SaveResult result, SaveText text, Path named) {
        String message =
                assertInstanceOf(SaveResult.Failed.class, result).message().brazilian();
        String upToReason = text.with(named, "\n").brazilian().split("\n")[0];
        assertTrue(message.startsWith(upToReason), message);
    }

    @Test
    void aSavedDocumentCanBeSavedAgain() {
        var saved = assertInstanceOf(SaveResult.Saved.class, save());
        assertEquals(List.of(), saved.notices());
        assertEquals(NEW, LevelFile.read(path));
        assertEquals(DocumentFile.Outside.SAME, saved.file().outside());
        assertInstanceOf(SaveResult.Saved.class, saver(FileOperations.REAL).save(saved.file(), OLD));
    }

    @Test
    void anUntitledDocumentIsSavedAs() {
        Path fresh = path.resolveSibling("b.json");
        var saved = assertInstanceOf(
                SaveResult.Saved.class, saver(FileOperations.REAL).saveAs(fresh, NEW));
        assertEquals(fresh, saved.file().path().orElseThrow());
        assertEquals(NEW, LevelFile.read(fresh));
    }

    @Test
    void aVersionOfAnotherProgramIsNotReplacedUnasked() throws IOException {
        LevelFile.save(path, DraftLevel.after(7));
        var asked = assertInstanceOf(SaveResult.ChangedOutside.class, save());
        assertEquals(SaveText.CHANGED_OUTSIDE.with(path), asked.question());
        assertEquals(DraftLevel.after(7), LevelFile.read(path));
        assertInstanceOf(SaveResult.Saved.class, saver(FileOperations.REAL).saveAs(path, NEW));
        Path backup = new Backups(folder.resolve("backups"), InstantSource.system())
                .of(path)
                .get(0)
                .file();
        assertEquals(DraftLevel.after(7), LevelFile.read(backup), "the other version is kept");
    }

    @Test
    void aNewTimeOfTheSameContentIsNoChange() throws IOException {
        Files.setLastModifiedTime(path, FileTime.fromMillis(0));
        assertInstanceOf(SaveResult.Saved.class, save());
    }

    @Test
    void aDeletedFileIsAskedFor() throws IOException {
        Files.delete(path);
        var asked = assertInstanceOf(SaveResult.ChangedOutside.class, save());
        assertEquals(SaveText.DELETED_OUTSIDE.with(path), asked.question());
        assertFalse(Files.exists(path));
        assertInstanceOf(SaveResult.Saved.class, saver(FileOperations.REAL).saveAs(path, NEW));
        assertEquals(NEW, LevelFile.read(path));
    }

    @Test
    void aDeletedFolderIsNamed() throws IOException {
        Files.delete(path);
        Files.delete(path.getParent());
        assertFailed(save(), SaveText.FOLDER_MISSING, path.getParent());
        assertFalse(Files.exists(path.getParent()));
    }

    @Test
    void aReadOnlyFileIsNotReplaced() throws IOException {
        Files.setPosixFilePermissions(path, PosixFilePermissions.fromString("r--r--r--"));
        assertFailed(save(), SaveText.READ_ONLY, path);
        assertFailed(saver(FileOperations.REAL).saveAs(path, NEW), SaveText.READ_ONLY, path);
        assertEquals(OLD, LevelFile.read(path));
    }

    @Test
    void aFolderIsNoFile() {
        assertFailed(saver(FileOperations.REAL).saveAs(path.getParent(), NEW), SaveText.IS_FOLDER, path.getParent());
    }

    @ParameterizedTest
    @EnumSource(
            value = FaultyFiles.Fault.class,
            names = {"REFUSED", "DISK_FULL"})
    void aFaultAtEveryOperationIsTold(FaultyFiles.Fault fault) throws IOException {
        byte[] before = Files.readAllBytes(path);
        int failed = 0;
        for (int k = 0; ; k++) {
            Files.write(path, before);
            FaultyFiles faulty = new FaultyFiles(fault, k);
            SaveResult result = saver(faulty).save(file, NEW);
            if (faulty.operations() <= k) {
                assertInstanceOf(SaveResult.Saved.class, result);
                break;
            }
            if (result instanceof SaveResult.Saved) {
                // The folder could not be forced, but the file is there.
                assertEquals(NEW, LevelFile.read(path));
                continue;
            }
            failed++;
            boolean isFull = fault == FaultyFiles.Fault.DISK_FULL;
            assertFailed(result, isFull ? SaveText.DISK_FULL : SaveText.NOT_SAVED, path);
            assertArrayEquals(before, Files.readAllBytes(path), "operation " + k);
        }
        assertTrue(failed >= 5, "only " + failed + " operations failed");
    }

    @Test
    void aLevelThatNoFileCanHoldIsNotSaved() {
        Level bad = Level.of("x".repeat(1000), "", OLD.environment(), List.of());
        SaveResult result = saver(FileOperations.REAL).save(file, bad);
        String message =
                assertInstanceOf(SaveResult.Failed.class, result).message().english();
        assertTrue(message.startsWith(SaveText.NO_LEVEL_FILE.with("").english()), message);
        assertEquals(OLD, LevelFile.read(path));
    }

    @Test
    void aLevelOfTheJarIsUntitled() {
        DocumentFile.Opened opened = DocumentFile.open("samples/empty.json");
        assertEquals(DocumentFile.UNTITLED, opened.file());
    }
}
