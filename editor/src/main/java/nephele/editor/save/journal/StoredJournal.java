package nephele.editor.save.journal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import nephele.engine.asset.AtomicFile;
import nephele.engine.level.json.FileOperations;

/**
 * The folder of one journal, with a log, a picture, and a locked file that tells other processes that its editor lives.
 * A file's lock ends with its process, however that ends.
 */
final class StoredJournal implements JournalStore {
    private static final String LOCK = "lock";

    private final Path folder;
    private FileChannel locked;

    /** Names a folder, which is made by the first write. */
    StoredJournal(Path folder) {
        this.folder = folder;
    }

    /**
     * Returns the journal in a folder, locked; empty if another process has it. On POSIX systems the lock of a journal of
     * this process would be lost by this call.
     */
    static Optional<StoredJournal> orphan(Path folder) throws IOException {
        var journal = new StoredJournal(folder);
        return journal.lock() ? Optional.of(journal) : Optional.empty();
    }

    Path folder() {
        return folder;
    }

    Path log() {
        return folder.resolve("edits.log");
    }

    Path picture() {
        return folder.resolve("picture.png");
    }

    private boolean lock() throws IOException {
        FileChannel channel =
                FileChannel.open(folder.resolve(LOCK), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        try {
            FileLock lock = channel.tryLock();
            if (lock != null) {
                locked = channel;
                return true;
            }
        } catch (OverlappingFileLockException ownProcess) {
            channel.close();
            return false;
        } catch (IOException noLocksHere) {
            // Some network folders have none: work that is offered twice is better than work that is not recorded.
            locked = channel;
            return true;
        }
        channel.close();
        return false;
    }

    @Override
    public void replaceLog(byte[] whole) throws IOException {
        Files.createDirectories(folder);
        if (locked == null || !Files.exists(folder.resolve(LOCK))) {
            release();
            lock();
        }
        AtomicFile.write(log(), whole);
        try {
            FileOperations.REAL.force(folder);
        } catch (IOException refused) {
            // Windows cannot force folders; the file itself is complete.
            return;
        }
    }

    @Override
    public void appendToLog(byte[] bytes) throws IOException {
        // Opened without CREATE each time: a deleted log is noticed, where an open channel would write into the void.
        try (FileChannel channel = FileChannel.open(log(), StandardOpenOption.WRITE, StandardOpenOption.APPEND)) {
            ByteBuffer rest = ByteBuffer.wrap(bytes);
            while (rest.hasRemaining()) {
                channel.write(rest);
            }
            channel.force(false);
        }
    }

    @Override
    public void replacePicture(byte[] png) throws IOException {
        AtomicFile.write(picture(), png);
    }

    @Override
    public void deleteLog() throws IOException {
        Files.deleteIfExists(log());
    }

    @Override
    public void release() {
        try {
            if (locked != null) {
                locked.close();
            }
        } catch (IOException alreadyGone) {
            // Its lock ends with it.
            locked = null;
        }
        locked = null;
    }

    /** Deletes the log first: what is left after a kill in between holds no work. */
    @Override
    public void delete() {
        deleteQuietly(log());
        deleteQuietly(picture());
        release();
        deleteQuietly(folder.resolve(LOCK));
        deleteQuietly(folder);
    }

    private static void deleteQuietly(Path file) {
        try {
            Files.deleteIfExists(file);
        } catch (IOException leftover) {
            // It holds no work, and the next search for journals tries again.
            return;
        }
    }
}
