package nephele.engine.level.json;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import nephele.engine.level.FaultyFiles;
import nephele.engine.level.Level;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class LevelFileTest {
    private static final Level OLD = LevelJsonTest.sections("\"name\": \"old\"");
    private static final Level NEW = LevelJsonTest.sections("\"name\": \"new\", \"description\": \"longer\"");

    @TempDir
    Path folder;

    private Path file;

    @BeforeEach
    void name() {
        file = folder.resolve("x.json");
    }

    private String notice() {
        return LevelFile.load(file).notice().orElse("");
    }

    private static void truncate(Path path) throws IOException {
        byte[] bytes = Files.readAllBytes(path);
        Files.write(path, Arrays.copyOf(bytes, bytes.length / 2));
    }

    @Test
    void aLevelAndItsBackupKeepTheModeAndALinkStays() throws IOException {
        LevelFile.save(file, OLD);
        assumeTrue(Files.getFileStore(file).supportsFileAttributeView("posix"), "a system without modes");
        var mode = PosixFilePermissions.fromString("rw-------");
        Files.setPosixFilePermissions(file, mode);
        Path link = Files.createSymbolicLink(folder.resolve("link.json"), file);
        LevelFile.save(link, NEW);
        assertTrue(Files.isSymbolicLink(link));
        assertEquals(NEW, LevelFile.read(file));
        assertEquals(mode, Files.getPosixFilePermissions(file));
        assertEquals(mode, Files.getPosixFilePermissions(folder.resolve("x.json.bak")));
        Files.delete(file);
        var refused = assertThrows(LevelSaveException.class, () -> LevelFile.save(link, NEW));
        assertTrue(refused.getMessage().contains("a link to a file that is missing"), refused.getMessage());
        assertTrue(Files.isSymbolicLink(link));
    }

    @Test
    void savingKeepsThePreviousVersionAndLeavesNothingElse() throws IOException {
        LevelFile.save(file, OLD);
        LevelFile.save(file, NEW);
        assertEquals(NEW, LevelFile.load(file).level());
        assertEquals("", notice());
        assertEquals(OLD, LevelFile.read(folder.resolve("x.json.bak")));
        try (var entries = Files.list(folder)) {
            assertEquals(2, entries.count());
        }
    }

    /** After a failure of any kind at any operation, loading finds exactly the old or the new level. */
    @ParameterizedTest
    @EnumSource(FaultyFiles.Fault.class)
    void everyFaultAtEveryOperationLeavesTheOldOrTheNewLevel(FaultyFiles.Fault fault) throws IOException {
        LevelFile.save(file, OLD);
        byte[] before = Files.readAllBytes(file);
        int reached = 0;
        for (int k = 0; k == reached; k++) {
            Files.write(file, before);
            FaultyFiles files = new FaultyFiles(fault, k);
            boolean saved = attempt(files);
            reached = files.operations() > k ? k + 1 : k;
            Level found = LevelFile.load(file).level();
            assertTrue(found.equals(OLD) || found.equals(NEW));
            if (!saved && (fault == FaultyFiles.Fault.REFUSED || fault == FaultyFiles.Fault.DISK_FULL)) {
                assertArrayEquals(before, Files.readAllBytes(file), "operation " + k);
            }
            if (saved) {
                assertEquals(NEW, found);
            }
            LevelFile.save(file, OLD);
            assertEquals(OLD, LevelFile.load(file).level());
        }
        assertTrue(reached >= 8, "only " + reached + " operations");
    }

    /** Returns true if the save reported success. */
    private boolean attempt(FaultyFiles files) {
        try {
            LevelFile.save(file, NEW, files);
            return true;
        } catch (LevelSaveException told) {
            assertTrue(told.getMessage().startsWith(file + ": cannot be saved: "), told.getMessage());
            return false;
        } catch (FaultyFiles.Killed end) {
            return false;
        }
    }

    @Test
    void aDamagedOrMissingFileIsReplacedByItsBackup() throws IOException {
        LevelFile.save(file, OLD);
        LevelFile.save(file, NEW);
        truncate(file);
        assertEquals(OLD, LevelFile.load(file).level());
        assertTrue(notice().contains("ends too early"), notice());
        assertTrue(notice().contains("x.json.bak"), notice());
        Files.delete(file);
        assertEquals(OLD, LevelFile.open(file.toString()).level());
        assertTrue(notice().contains("no such file"), notice());
    }

    @Test
    void aDamagedFileDoesNotPushTheGoodBackupOut() throws IOException {
        LevelFile.save(file, OLD);
        LevelFile.save(file, NEW);
        truncate(file);
        LevelFile.save(file, NEW);
        assertEquals(OLD, LevelFile.read(folder.resolve("x.json.bak")));
    }

    /** An author's mistake is reported and not hidden behind the previous version. */
    @Test
    void aWronglyWrittenFileIsNotReplaced() throws IOException {
        LevelFile.save(file, OLD);
        LevelFile.save(file, NEW);
        Files.writeString(file, "{\"format\": \"nephele-level\", \"version\": 1, \"colour\": 1}");
        assertThrows(LevelFormatException.class, () -> LevelFile.load(file));
    }

    @Test
    void whenBothAreBadTheFilesOwnProblemIsTold() throws IOException {
        LevelFile.save(file, OLD);
        LevelFile.save(file, NEW);
        truncate(file);
        truncate(folder.resolve("x.json.bak"));
        LevelFormatException told = assertThrows(LevelFormatException.class, () -> LevelFile.load(file));
        assertTrue(told.getMessage().startsWith(file + ": "), told.getMessage());
    }

    @Test
    void whatCannotBeReadBackIsNotWritten() throws IOException {
        LevelFile.save(file, OLD);
        byte[] before = Files.readAllBytes(file);
        Level broken = Level.of("\u0007", "", OLD.environment(), OLD.cameras());
        assertThrows(LevelFormatException.class, () -> LevelFile.save(file, broken));
        assertArrayEquals(before, Files.readAllBytes(file));
    }

    @Test
    void foldersAndMissingFoldersAreNamed() {
        LevelFormatException folderRead = assertThrows(LevelFormatException.class, () -> LevelFile.load(folder));
        assertTrue(folderRead.getMessage().contains("this is a folder"), folderRead.getMessage());
        assertThrows(LevelSaveException.class, () -> LevelFile.save(folder.resolve("no/x.json"), OLD));
        assertThrows(LevelSaveException.class, () -> LevelFile.save(folder, OLD));
        assertThrows(LevelFormatException.class, () -> LevelFile.open("no/such/level.json"));
        assertThrows(LevelFormatException.class, () -> LevelFile.open("a\u0000b"));
    }

    @Test
    void aLinkStaysALink() throws IOException {
        Path link = folder.resolve("link.json");
        LevelFile.save(file, OLD);
        Files.createSymbolicLink(link, file);
        LevelFile.save(link, NEW);
        assertTrue(Files.isSymbolicLink(link));
        assertEquals(NEW, LevelFile.read(file));
        assertFalse(Files.exists(folder.resolve("link.json.tmp")));
    }
}
