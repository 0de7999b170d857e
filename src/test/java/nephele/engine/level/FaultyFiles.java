package nephele.engine.level;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.util.Arrays;
import nephele.engine.level.json.FileOperations;

/** The real file system up to operation {@code k}, which fails in one of several ways. */
public final class FaultyFiles implements FileOperations {
    /** The failure at the operation. */
    public enum Fault {
        /** The operation is refused and changes nothing. */
        REFUSED,
        /** A write stops half-way, then the disk is full; other operations are refused. */
        DISK_FULL,
        /** The process ends before it. */
        KILLED_BEFORE,
        /** The process ends half-way through a write. */
        KILLED_WITHIN,
        /** The process ends after it. */
        KILLED_AFTER
    }

    /** Represents the end of the process: no code may catch it and continue. */
    public static final class Killed extends Error {
        private static final long serialVersionUID = 1;
    }

    private final Fault fault;
    private final int at;
    private int done;
    private boolean killed;

    public FaultyFiles(Fault fault, int at) {
        this.fault = fault;
        this.at = at;
    }

    /** Returns the number of operations so far. */
    public int operations() {
        return done;
    }

    private interface Operation {
        void run() throws IOException;
    }

    private void step(Operation whole, Operation half) throws IOException {
        if (killed) {
            throw new Killed();
        }
        if (done++ != at) {
            whole.run();
            return;
        }
        switch (fault) {
            case REFUSED -> {}
            case DISK_FULL, KILLED_WITHIN -> half.run();
            case KILLED_BEFORE -> {}
            case KILLED_AFTER -> whole.run();
        }
        killed = fault != Fault.REFUSED && fault != Fault.DISK_FULL;
        if (killed) {
            throw new Killed();
        }
        throw new FileSystemException("f", null, fault == Fault.DISK_FULL ? "No space left on device" : "refused");
    }

    @Override
    public byte[] read(Path file, int most) throws IOException {
        byte[][] content = new byte[1][];
        step(() -> content[0] = REAL.read(file, most), () -> {});
        return content[0];
    }

    @Override
    public void write(Path file, byte[] bytes, Path like) throws IOException {
        step(() -> REAL.write(file, bytes, like), () -> REAL.write(file, Arrays.copyOf(bytes, bytes.length / 2), like));
    }

    @Override
    public void force(Path fileOrFolder) throws IOException {
        step(() -> REAL.force(fileOrFolder), () -> {});
    }

    @Override
    public void moveOver(Path from, Path to) throws IOException {
        step(() -> REAL.moveOver(from, to), () -> {});
    }

    @Override
    public void deleteIfExists(Path file) throws IOException {
        step(() -> REAL.deleteIfExists(file), () -> {});
    }

    @Override
    public boolean exists(Path file) {
        return REAL.exists(file);
    }
}
