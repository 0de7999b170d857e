package nephele.engine.level.json;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import nephele.engine.asset.AtomicFile;

/** What saving and loading ask of a file system: the seam at which tests let each operation fail. */
public interface FileOperations {
    /** The whole file, or its first {@code most + 1} bytes when it has more than {@code most}. */
    byte[] read(Path file, int most) throws IOException;

    /** Creates or empties the file and fills it. */
    void write(Path file, byte[] bytes) throws IOException;

    /** Returns when a file's content, or a folder's entries, would survive a power cut. */
    void force(Path fileOrFolder) throws IOException;

    /** Replaces {@code to} in one step: whoever looks sees the old or the new file. */
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
        public void write(Path file, byte[] bytes) throws IOException {
            Files.write(file, bytes);
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
