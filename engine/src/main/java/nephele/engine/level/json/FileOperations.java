package nephele.engine.level.json;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import nephele.engine.asset.AtomicFile;

/** The file-system operations of saving and loading; tests replace them to let each operation fail. */
public interface FileOperations {
    /** Returns the whole file, or its first {@code most + 1} bytes if it has more than {@code most}. */
    byte[] read(Path file, int most) throws IOException;

    /**
     * Creates or truncates the file and writes it.
     *
     * @param like whose mode, group and owner the file gets, if it exists
     */
    void write(Path file, byte[] bytes, Path like) throws IOException;

    /** Returns after a file's content, or a folder's entries, would survive a power failure. */
    void force(Path fileOrFolder) throws IOException;

    /** Replaces {@code to} atomically: every reader sees the old or the new file. */
    void moveOver(Path from, Path to) throws IOException;

    void deleteIfExists(Path file) throws IOException;

    boolean exists(Path file);

    /** The real file system. */
    FileOperations REAL = new FileOperations() {
        @Override
        public byte[] read(Path file, int most) throws IOException {
            return AtomicFile.read(file, most);
        }

        @Override
        public void write(Path file, byte[] bytes, Path like) throws IOException {
            Files.write(file, new byte[0]);
            AtomicFile.adopt(file, like);
            Files.write(file, bytes, StandardOpenOption.WRITE);
        }

        @Override
        public void force(Path fileOrFolder) throws IOException {
            var mode = Files.isDirectory(fileOrFolder) ? StandardOpenOption.READ : StandardOpenOption.WRITE;
            try (FileChannel channel = FileChannel.open(fileOrFolder, mode)) {
                channel.force(true);
            }
        }

        @Override
        public void moveOver(Path from, Path to) throws IOException {
            Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
        }

        @Override
        public void deleteIfExists(Path file) throws IOException {
            Files.deleteIfExists(file);
        }

        @Override
        public boolean exists(Path file) {
            return Files.exists(file);
        }
    };
}
