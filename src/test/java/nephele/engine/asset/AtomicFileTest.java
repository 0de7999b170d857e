package nephele.engine.asset;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.channels.ClosedChannelException;
import java.nio.charset.MalformedInputException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class AtomicFileTest {
    private static final byte[] NEW = {1, 2, 3};

    @TempDir
    Path folder;

    private List<String> names() throws IOException {
        try (var files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    private String refusal(Path file) {
        var refused = assertThrows(IOException.class, () -> AtomicFile.write(file, NEW));
        assertTrue(refused.getMessage().startsWith(file + ": can't be written: "), refused.getMessage());
        return refused.getMessage();
    }

    @Test
    void aFileIsReplacedAndNothingElseIsLeft() throws IOException {
        var file = Files.write(folder.resolve("a.png"), new byte[1000]);
        AtomicFile.write(file, NEW);
        assertArrayEquals(NEW, Files.readAllBytes(file));
        assertEquals(List.of("a.png"), names());
    }

    @Test
    void missingFoldersAreMade() throws IOException {
        AtomicFile.write(folder.resolve("deep/er/a.png"), NEW);
        assertArrayEquals(NEW, Files.readAllBytes(folder.resolve("deep/er/a.png")));
    }

    @Test
    void anEmptyFolderIsNotReplaced() throws IOException {
        var inTheWay = Files.createDirectory(folder.resolve("a.png"));
        assertTrue(refusal(inTheWay).endsWith("it is a folder"));
        assertTrue(Files.isDirectory(inTheWay));
        assertEquals(List.of("a.png"), names());
    }

    @Test
    void aLinkStaysALinkAndOneToNothingIsRefused() throws IOException {
        var real = Files.write(folder.resolve("real.png"), new byte[1]);
        var link = Files.createSymbolicLink(folder.resolve("link.png"), real);
        AtomicFile.write(link, NEW);
        assertTrue(Files.isSymbolicLink(link));
        assertArrayEquals(NEW, Files.readAllBytes(real));
        Files.delete(real);
        assertTrue(refusal(link).contains("link to a file that is missing"));
        assertEquals(List.of("link.png"), names());
    }

    @Test
    void aFileKeepsItsModeAndOwnerAlsoThroughALink() throws IOException {
        var file = Files.write(folder.resolve("a.png"), new byte[1]);
        assumeTrue(Files.getFileStore(file).supportsFileAttributeView("posix"), "a system without modes");
        var mode = PosixFilePermissions.fromString("rw-rw---x");
        Files.setPosixFilePermissions(file, mode);
        boolean isRoot = (int) Files.getAttribute(file, "unix:uid") == 0;
        if (isRoot) {
            Files.setAttribute(file, "unix:uid", 1234);
            Files.setAttribute(file, "unix:gid", 4321);
        }
        var link = Files.createSymbolicLink(folder.resolve("link.png"), file);
        var copy = folder.resolve("copy.png");
        AtomicFile.write(link, NEW);
        AtomicFile.copy(link, copy);
        for (Path each : List.of(file, copy)) {
            assertArrayEquals(NEW, Files.readAllBytes(each));
            assertEquals(mode, Files.getPosixFilePermissions(each));
            assertTrue(!isRoot || Files.getAttribute(each, "unix:uid").equals(1234));
            assertTrue(!isRoot || Files.getAttribute(each, "unix:gid").equals(4321));
        }
        assertTrue(Files.isSymbolicLink(link));
    }

    @Test
    void aFullOrReadOnlyDiskIsToldWithWhatToDo() {
        for (String system :
                List.of("No space left on device", "Disk quota exceeded", "Not enough space on the disk")) {
            var problem = new FileSystemException("a.png", null, system);
            assertEquals("the disk is full; make room on it, or choose another place", AtomicFile.reason(problem));
        }
        assertEquals(
                "the disk is read-only; choose another place",
                AtomicFile.reason(new FileSystemException("a.png", null, "Read-only file system")));
    }

    @Test
    void aFolderThatIsAFileIsNamed() throws IOException {
        var noFolder = Files.write(folder.resolve("note"), NEW);
        assertTrue(refusal(noFolder.resolve("a.png")).endsWith("is not a folder"));
    }

    @Test
    void aPipeIsNotAFileAndADeviceIsReadNoFartherThanAsked() throws Exception {
        assumeTrue(Files.exists(Path.of("/dev/zero")), "a system without device files");
        var pipe = folder.resolve("pipe");
        assertEquals(0, new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor());
        var refused = assertThrows(IOException.class, () -> AtomicFile.read(pipe, 10));
        assertEquals("it is not a file", AtomicFile.reason(refused));
        assertEquals(11, AtomicFile.read(Path.of("/dev/zero"), 10).length);
    }

    /** A reason is in plain words, whatever fails. */
    @Test
    void aReasonNamesNoExceptionOfJava() {
        for (IOException problem : List.of(
                new FileAlreadyExistsException("x"),
                new NotDirectoryException("x"),
                new DirectoryNotEmptyException("x"),
                new FileSystemException("x"),
                new MalformedInputException(1),
                new ClosedChannelException(),
                new IOException())) {
            String reason = AtomicFile.reason(problem);
            assertFalse(reason.contains("Exception") || reason.contains("Input length"), reason);
        }
    }
}
