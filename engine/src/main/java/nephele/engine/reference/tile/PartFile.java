package nephele.engine.reference.tile;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
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

    /** Returns where it is. */
    public Path path() {
        return path;
    }

    /** Forces what is written to the disk and closes the file. */
    @Override
    public synchronized void close() throws IOException {
        try (file) {
            file.force(true);
        }
    }
}
