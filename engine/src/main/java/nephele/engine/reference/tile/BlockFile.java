package nephele.engine.reference.tile;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import java.util.zip.CRC32C;
import nephele.engine.asset.AtomicFile;

/**
 * Numbered blocks of floats behind a head of text, in a file to which they are written as they are worked out. A block
 * that was cut off when the program ended is noticed, and is written again over its rest. A lock, which ends with the
 * process, keeps two runs from writing to it.
 *
 * <p>Bytes: the head with an empty line at its end, then for each block its number, how many values it has, the values,
 * and a checksum of all of these. Big-endian.
 */
public final class BlockFile implements AutoCloseable {
    /** The longest head that is read. */
    private static final int MOST_CHARACTERS = 1 << 16;

    private static final String HEAD_END = "\n\n";
    private static final int RECORD_HEAD_BYTES = 8;
    private static final int SUM_BYTES = 4;

    private final Path path;
    private final FileChannel file;
    private final String head;
    private long end;

    /** A numbered block. */
    public record Block(int number, float[] values) {}

    /** Decides by a block's number, and by how many values it claims to have, whether it can be one. */
    @FunctionalInterface
    public interface Possible {
        boolean test(int number, int values);
    }

    private BlockFile(Path path, FileChannel file) throws IOException {
        this.path = path;
        this.file = file;
        ByteBuffer first = read(0, (int) Math.min(file.size(), MOST_CHARACTERS));
        String text = new String(first.array(), 0, first.limit(), StandardCharsets.UTF_8);
        int length = text.indexOf(HEAD_END) + HEAD_END.length();
        head = length < HEAD_END.length() ? null : text.substring(0, length);
        end = head == null ? 0 : head.getBytes(StandardCharsets.UTF_8).length;
    }

    /**
     * Opens or creates a file to go on with.
     *
     * @throws PartFileException if another run writes to it
     */
    public static BlockFile open(Path path) throws IOException {
        if (path.toAbsolutePath().getParent() != null) {
            Files.createDirectories(path.toAbsolutePath().getParent());
        }
        FileChannel file =
                FileChannel.open(path, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
        try {
            lock(path, file);
            return new BlockFile(path, file);
        } catch (IOException | RuntimeException failure) {
            file.close();
            throw failure;
        }
    }

    /** Opens a file to read it only. */
    static BlockFile reading(Path path) throws IOException {
        return new BlockFile(path, FileChannel.open(path, StandardOpenOption.READ));
    }

    private static void lock(Path path, FileChannel file) throws IOException {
        boolean isFree;
        try {
            isFree = file.tryLock() != null;
        } catch (OverlappingFileLockException ofThisProcess) {
            isFree = false;
        }
        if (!isFree) {
            throw new PartFileException(path, "another run writes to it; wait for it, or choose another --out");
        }
    }

    /** Returns true if the file is empty or cut off within a head, so that there is nothing in it. */
    public boolean isEmpty(String wanted) throws IOException {
        byte[] bytes = wanted.getBytes(StandardCharsets.UTF_8);
        return file.size() < bytes.length
                && read(0, (int) file.size()).equals(ByteBuffer.wrap(bytes, 0, (int) file.size()));
    }

    /** Returns the head with its empty line; empty if the file begins with none. */
    public Optional<String> head() {
        return Optional.ofNullable(head);
    }

    /** Replaces everything by a head, which ends with an empty line. */
    public void begin(String newHead) throws IOException {
        try {
            file.truncate(0);
            ByteBuffer bytes = ByteBuffer.wrap(newHead.getBytes(StandardCharsets.UTF_8));
            end = bytes.limit();
            write(bytes, 0);
        } catch (IOException problem) {
            throw AtomicFile.notWritten(path, problem);
        }
    }

    /** Returns the next block; empty if there is none or it is incomplete, damaged or impossible. */
    public Optional<Block> next(Possible isPossible) throws IOException {
        ByteBuffer start = read(end, RECORD_HEAD_BYTES);
        if (start.limit() < RECORD_HEAD_BYTES) {
            return Optional.empty();
        }
        int number = start.getInt();
        int values = start.getInt();
        long bytes = bytes(values);
        if (values < 0 || bytes > file.size() - end || !isPossible.test(number, values)) {
            return Optional.empty();
        }
        ByteBuffer whole = read(end, (int) bytes);
        if (whole.limit() < bytes || sum(whole) != whole.getInt(whole.limit() - SUM_BYTES)) {
            return Optional.empty();
        }
        end += bytes;
        float[] floats = new float[values];
        whole.position(RECORD_HEAD_BYTES).asFloatBuffer().get(floats);
        return Optional.of(new Block(number, floats));
    }

    /** Returns the place behind the last whole block that was read or written, bytes. */
    long end() {
        return end;
    }

    boolean isAtEnd() throws IOException {
        return end == file.size();
    }

    /** Drops what is behind the last block that was read. */
    public void truncate() throws IOException {
        file.truncate(end);
    }

    /** Writes a block behind the last one; may be called by any thread. */
    public synchronized void append(Block block) throws IOException {
        ByteBuffer whole = ByteBuffer.allocate((int) bytes(block.values().length));
        whole.putInt(block.number()).putInt(block.values().length);
        whole.asFloatBuffer().put(block.values());
        whole.putInt(whole.capacity() - SUM_BYTES, sum(whole)).clear();
        try {
            write(whole, end);
        } catch (IOException problem) {
            throw AtomicFile.notWritten(path, problem);
        }
        end += whole.capacity();
    }

    private static long bytes(int values) {
        return RECORD_HEAD_BYTES + (long) Float.BYTES * values + SUM_BYTES;
    }

    private static int sum(ByteBuffer whole) {
        var sum = new CRC32C();
        sum.update(whole.array(), 0, whole.capacity() - SUM_BYTES);
        return (int) sum.getValue();
    }

    /** Returns the bytes at a place, fewer at the end of the file. */
    private ByteBuffer read(long at, int bytes) throws IOException {
        ByteBuffer read = ByteBuffer.allocate(bytes);
        while (read.hasRemaining() && file.read(read, at + read.position()) >= 0) {
            continue;
        }
        return read.flip();
    }

    private void write(ByteBuffer bytes, long at) throws IOException {
        while (bytes.hasRemaining()) {
            file.write(bytes, at + bytes.position());
        }
    }

    /** Forces what is written to the disk and closes the file. */
    @Override
    public synchronized void close() throws IOException {
        try (file) {
            if (file.isOpen()) {
                file.force(true);
            }
        }
    }
}
