package nephele.editor.save.journal;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.util.Arrays;

/** A journal's files on a disk that can become full; a record is then written by half. */
final class FaultyStore implements JournalStore {
    private final JournalStore real;
    private volatile boolean isFull;
    private volatile Runnable onRefusal = () -> {};

    FaultyStore(JournalStore real) {
        this.real = real;
    }

    void full(boolean full) {
        isFull = full;
    }

    /** Runs an action once, within the next write that finds the disk full. */
    void onRefusal(Runnable action) {
        onRefusal = () -> {
            onRefusal = () -> {};
            action.run();
        };
    }

    private void failIfFull() throws IOException {
        if (isFull) {
            onRefusal.run();
            throw new FileSystemException("f", null, "No space left on device");
        }
    }

    @Override
    public void replaceLog(byte[] whole) throws IOException {
        failIfFull();
        real.replaceLog(whole);
    }

    @Override
    public void appendToLog(byte[] bytes) throws IOException {
        real.appendToLog(isFull ? Arrays.copyOf(bytes, bytes.length / 2) : bytes);
        failIfFull();
    }

    @Override
    public void replacePicture(byte[] png) throws IOException {
        failIfFull();
        real.replacePicture(png);
    }

    @Override
    public void deleteLog() throws IOException {
        real.deleteLog();
    }

    @Override
    public void release() {
        real.release();
    }

    @Override
    public void delete() {
        real.delete();
    }
}
