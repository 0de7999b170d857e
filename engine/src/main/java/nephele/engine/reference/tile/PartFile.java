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
 * The file that finished tiles are written to. A tile that was cut off when the program ended is dropped when the file is
 * opened again, and the rest is traced on. A lock, which ends with the process, keeps two runs from writing to it.
 */
public final class PartFile implements AutoCloseable {
    private final Path path;
    private final FileChannel file;
    private final TileRecords records;
    private final String replaced;
    private int found;

    private PartFile(Path path, FileChannel file, TileRecords records, String replaced) {
        this.path = path;
        this.file = file;
        this.records = records;
        this.replaced = replaced;
    }

    /**
     * Opens or creates the part of a picture and puts the tiles that it holds into the picture. A part of another picture
     * is replaced.
     *
     * @throws PartFileException if another run writes to it or it is no part file
     */
    public static PartFile open(Path path, PartHeader header, TiledPicture picture) throws IOException {
        if (path.toAbsolutePath().getParent() != null) {
            Files.createDirectories(path.toAbsolutePath().getParent());
        }
        FileChannel file =
                FileChannel.open(path, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
        try {
            lock(path, file);
            PartFile part = opened(path, file, header);
            part.restore(picture);
            return part;
        } catch (IOException | RuntimeException failure) {
            file.close();
            throw failure;
        }
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

    private static PartFile opened(Path path, FileChannel file, PartHeader header) throws IOException {
        if (file.size() == 0) {
            return new PartFile(path, file, begun(path, file, header), null);
        }
        TileRecords known = TileRecords.open(file);
        if (known == null) {
            throw new PartFileException(path, "is in the way and no part of a picture; delete or rename it");
        }
        String difference = header.difference(known.header());
        if (!known.header().shard().equals(header.shard())) {
            difference += (difference.isEmpty() ? "" : "; ") + "shard "
                    + known.header().shard();
        }
        return difference.isEmpty()
                ? new PartFile(path, file, known, null)
                : new PartFile(path, file, begun(path, file, header), difference);
    }

    private static TileRecords begun(Path path, FileChannel file, PartHeader header) throws IOException {
        try {
            return TileRecords.begin(file, header);
        } catch (IOException problem) {
            throw AtomicFile.notWritten(path, problem);
        }
    }

    private void restore(TiledPicture picture) throws IOException {
        for (TilePixels pixels = records.next(); pixels != null; pixels = records.next()) {
            found += picture.has(pixels.tile()) ? 0 : 1;
            picture.put(pixels);
        }
        file.truncate(records.end());
    }

    /** Returns how many tiles were in the file. */
    public int found() {
        return found;
    }

    /** Returns how the picture differs whose part was replaced; empty if none was. */
    public Optional<String> replaced() {
        return Optional.ofNullable(replaced);
    }

    /** Writes a finished tile; may be called by any thread. */
    public synchronized void append(TilePixels pixels) throws IOException {
        try {
            records.append(pixels);
        } catch (IOException problem) {
            throw AtomicFile.notWritten(path, problem);
        }
    }

    /** Forces what is written to the disk and closes the file. */
    @Override
    public synchronized void close() throws IOException {
        try (file) {
            file.force(true);
        }
    }

    /**
     * The bytes of a part file: the head, then a record for each tile with its number, how many values it has, radiances,
     * variances, and a checksum of all of these. Big-endian.
     */
    static final class TileRecords {
        private static final int HEAD_BYTES = 8;
        private static final int SUM_BYTES = 4;
        private static final String HEAD_END = "\n\n";

        private final FileChannel file;
        private final PartHeader header;
        private long end;

        private TileRecords(FileChannel file, PartHeader header, long end) {
            this.file = file;
            this.header = header;
            this.end = end;
        }

        /** Reads the head; returns {@code null} if the file does not begin with one. */
        static TileRecords open(FileChannel file) throws IOException {
            ByteBuffer first = read(file, 0, (int) Math.min(file.size(), PartHeader.MOST_CHARACTERS));
            String text = new String(first.array(), 0, first.limit(), StandardCharsets.UTF_8);
            int length = text.indexOf(HEAD_END) + HEAD_END.length();
            PartHeader header = length < HEAD_END.length() ? null : PartHeader.parse(text.substring(0, length));
            return header == null
                    ? null
                    : new TileRecords(file, header, header.text().getBytes(StandardCharsets.UTF_8).length);
        }

        /** Makes an empty part of the file. */
        static TileRecords begin(FileChannel file, PartHeader header) throws IOException {
            file.truncate(0);
            ByteBuffer head = ByteBuffer.wrap(header.text().getBytes(StandardCharsets.UTF_8));
            var records = new TileRecords(file, header, head.limit());
            write(file, head, 0);
            return records;
        }

        PartHeader header() {
            return header;
        }

        /** Returns the place behind the last whole record that was read or written, bytes. */
        long end() {
            return end;
        }

        boolean isAtEnd() throws IOException {
            return end == file.size();
        }

        /** Returns the next record; {@code null} if there is none or it is incomplete or damaged. */
        TilePixels next() throws IOException {
            ByteBuffer head = read(file, end, HEAD_BYTES);
            if (head.limit() < HEAD_BYTES) {
                return null;
            }
            int tile = head.getInt();
            int values = head.getInt();
            if (tile < 0 || tile >= header.tiles().count()) {
                return null;
            }
            int colours = 3 * header.tiles().pixels(tile);
            if (values != colours && values != 2 * colours) {
                return null;
            }
            ByteBuffer whole = read(file, end, bytes(values));
            if (whole.limit() < bytes(values) || sum(whole) != whole.getInt(whole.limit() - SUM_BYTES)) {
                return null;
            }
            end += whole.limit();
            whole.position(HEAD_BYTES);
            return new TilePixels(tile, floats(whole, colours), floats(whole, values - colours));
        }

        /** Writes a record behind the last one. */
        void append(TilePixels pixels) throws IOException {
            int values = pixels.rgb().length + pixels.variance().length;
            ByteBuffer whole = ByteBuffer.allocate(bytes(values));
            whole.putInt(pixels.tile()).putInt(values);
            put(whole, pixels.rgb());
            put(whole, pixels.variance());
            whole.putInt(sum(whole)).flip();
            write(file, whole, end);
            end += whole.limit();
        }

        private static int bytes(int values) {
            return HEAD_BYTES + Float.BYTES * values + SUM_BYTES;
        }

        private static int sum(ByteBuffer whole) {
            var sum = new CRC32C();
            sum.update(whole.array(), 0, whole.capacity() - SUM_BYTES);
            return (int) sum.getValue();
        }

        private static float[] floats(ByteBuffer from, int count) {
            float[] values = new float[count];
            from.asFloatBuffer().get(values);
            from.position(from.position() + Float.BYTES * count);
            return values;
        }

        private static void put(ByteBuffer to, float[] values) {
            for (float value : values) {
                to.putFloat(value);
            }
        }

        /** Returns the bytes at a place, fewer at the end of the file. */
        private static ByteBuffer read(FileChannel file, long at, int bytes) throws IOException {
            ByteBuffer read = ByteBuffer.allocate(bytes);
            while (read.hasRemaining() && file.read(read, at + read.position()) >= 0) {
                continue;
            }
            return read.flip();
        }

        private static void write(FileChannel file, ByteBuffer bytes, long at) throws IOException {
            while (bytes.hasRemaining()) {
                file.write(bytes, at + bytes.position());
            }
        }
    }
}
