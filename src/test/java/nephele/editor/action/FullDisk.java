package nephele.editor.action;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import nephele.engine.level.json.FileOperations;

/** File operations of a machine on which one folder is on a full disk. */
record FullDisk(Path folder) implements FileOperations {
    @Override
    public byte[] read(Path file, int most) throws IOException {
        return REAL.read(file, most);
    }

    @Override
    public void write(Path file, byte[] bytes, Path like) throws IOException {
        if (file.toAbsolutePath().startsWith(folder)) {
            throw new FileSystemException(file.toString(), null, "No space left on device");
        }
        REAL.write(file, bytes, like);
    }

    @Override
    public void force(Path fileOrFolder) throws IOException {
        REAL.force(fileOrFolder);
    }

    @Override
    public void moveOver(Path from, Path to) throws IOException {
        REAL.moveOver(from, to);
    }

    @Override
    public void deleteIfExists(Path file) throws IOException {
        REAL.deleteIfExists(file);
    }

    @Override
    public boolean exists(Path file) {
        return REAL.exists(file);
    }
}
