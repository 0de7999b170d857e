package nephele.engine.asset;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.charset.CharacterCodingException;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFileAttributes;
import java.util.Locale;

/**
 * Reads and writes files as a whole. If writing fails at any point, the file is the old or the new one, never a part:
 * the bytes are written to a temporary file beside it, forced to disk and renamed atomically. Devices are written
 * directly.
 */
public final class AtomicFile {
    private static final int UNIX_KIND = 0170000;
    private static final int UNIX_CHARACTER_DEVICE = 0020000;

    private AtomicFile() {}

    /**
     * Returns the whole file, or its first {@code most + 1} bytes if it has more than {@code most}. Pipes and sockets,
     * which could block for ever, are rejected.
     */
    public static byte[] read(Path file, int most) throws IOException {
        if (Files.readAttributes(file, BasicFileAttributes.class).isOther() && !isCharacterDevice(file)) {
            throw new FileSystemException(file.toString(), null, "it is not a file");
        }
        try (var stream = Files.newInputStream(file)) {
            return stream.readNBytes(most + 1);
        }
    }

    /**
     * Replaces or creates the file, and its folder if that is missing. A link stays a link, and the file keeps its mode
     * and, as far as this user may set them, its group and owner; a device is written to.
     *
     * @throws IOException with a message for users that names the file and the reason; the file is then unchanged
     */
    public static void write(Path file, byte[] bytes) throws IOException {
        write(file, bytes, file);
    }

    /** Writes a copy of a file as {@link #write} does; a new one has the mode of the file that is copied. */
    public static void copy(Path from, Path to) throws IOException {
        write(to, Files.readAllBytes(from), from);
    }

    /** Writes as {@link #write(Path, byte[])} does; a new file has the mode, group and owner of another one. */
    public static void write(Path file, byte[] bytes, Path like) throws IOException {
        try {
            Path target = target(file);
            if (Files.exists(target)) {
                overwrite(target, bytes);
            } else {
                makeFolder(target);
                replace(target, bytes, like);
            }
        } catch (IOException problem) {
            throw notWritten(file, problem);
        }
    }

    /** Returns a failure with a message for users that names the file, which the system's own often doesn't. */
    public static IOException notWritten(Path file, IOException problem) {
        return new IOException(file + ": can't be written: " + reason(problem), problem);
    }

    /**
     * Returns the file that a save replaces: links are followed, so that they stay.
     *
     * @throws IOException if it is a link to a file that is missing
     */
    public static Path target(Path file) throws IOException {
        if (Files.exists(file)) {
            return file.toRealPath();
        }
        if (Files.isSymbolicLink(file)) {
            throw new IOException("it is a link to a file that is missing");
        }
        return file.toAbsolutePath();
    }

    /** Gives a new file the mode, group and owner of one that exists, as far as the system has and allows them. */
    public static void adopt(Path fresh, Path like) throws IOException {
        var view = Files.getFileAttributeView(fresh, PosixFileAttributeView.class);
        if (view == null || !Files.exists(like)) {
            return;
        }
        PosixFileAttributes old = Files.readAttributes(like, PosixFileAttributes.class);
        PosixFileAttributes own = view.readAttributes();
        if (!own.group().equals(old.group()) || !own.owner().equals(old.owner())) {
            try {
                view.setGroup(old.group());
                view.setOwner(old.owner());
            } catch (FileSystemException refused) {
                // Only a group's members may give a file to it, and only an administrator to another user.
                view.setPermissions(old.permissions());
                return;
            }
        }
        view.setPermissions(old.permissions());
    }

    private static void overwrite(Path file, byte[] bytes) throws IOException {
        if (Files.isDirectory(file)) {
            throw new IOException("it is a folder");
        }
        if (!Files.isWritable(file)) {
            throw new AccessDeniedException(file.toString());
        }
        if (Files.isRegularFile(file)) {
            replace(file, bytes, file);
        } else {
            Files.write(file, bytes, StandardOpenOption.WRITE);
        }
    }

    private static void makeFolder(Path file) throws IOException {
        try {
            Files.createDirectories(file.getParent());
        } catch (FileAlreadyExistsException noFolder) {
            throw new IOException(noFolder.getFile() + " is not a folder", noFolder);
        }
    }

    private static void replace(Path file, byte[] bytes, Path like) throws IOException {
        Path fresh = file.resolveSibling(String.format(Locale.ROOT, ".nephele-%x.tmp", System.nanoTime()));
        try {
            Files.createFile(fresh);
            adopt(fresh, like);
            Files.write(fresh, bytes, StandardOpenOption.WRITE);
            try (var channel = FileChannel.open(fresh, StandardOpenOption.WRITE)) {
                channel.force(true);
            }
            Files.move(fresh, file, StandardCopyOption.ATOMIC_MOVE);
        } finally {
            Files.deleteIfExists(fresh);
        }
    }

    private static boolean isCharacterDevice(Path file) throws IOException {
        boolean unix = file.getFileSystem().supportedFileAttributeViews().contains("unix");
        return unix && ((int) Files.getAttribute(file, "unix:mode") & UNIX_KIND) == UNIX_CHARACTER_DEVICE;
    }

    /** Returns true if there is no room, or no more for this user; each system has words of its own for it. */
    public static boolean isDiskFull(IOException problem) {
        String detail = detail(problem);
        return detail != null
                && detail.toLowerCase(Locale.ROOT).matches(".*(no space left|quota exceeded|not enough space).*");
    }

    private static String detail(IOException problem) {
        return problem instanceof FileSystemException system ? system.getReason() : problem.getMessage();
    }

    /** Returns the reason of a failure in words that complete "FILE can't be read: ". */
    public static String reason(IOException problem) {
        if (problem instanceof AccessDeniedException) {
            return "access is denied";
        }
        if (problem instanceof NoSuchFileException) {
            return "there is no such file or folder";
        }
        if (isDiskFull(problem)) {
            return "the disk is full; make room on it, or choose another place";
        }
        if (problem instanceof FileAlreadyExistsException) {
            return "a file of this name is there already";
        }
        if (problem instanceof NotDirectoryException) {
            return "it is no folder";
        }
        if (problem instanceof DirectoryNotEmptyException) {
            return "the folder is not empty";
        }
        if (problem instanceof CharacterCodingException) {
            return "it is no UTF-8 text";
        }
        String detail = detail(problem);
        if ("Read-only file system".equals(detail)) {
            return "the disk is read-only; choose another place";
        }
        return detail == null || detail.isBlank() ? "the system does not say why" : detail;
    }
}
