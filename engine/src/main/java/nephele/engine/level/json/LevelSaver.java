package nephele.engine.level.json;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import nephele.engine.asset.AtomicFile;
import nephele.engine.level.Level;

/**
 * Replaces a file so that a complete version of it exists at every moment, whatever fails: it writes the new content to
 * a file beside it, forces it to disk and renames it over the old one atomically (Pillai et al., OSDI 2014, on why each
 * step is needed). The previous version stays as {@code .bak}.
 */
final class LevelSaver {
    private final FileOperations files;

    LevelSaver(FileOperations files) {
        this.files = files;
    }

    void save(Path path, Level level) throws LevelSaveException {
        byte[] bytes = checkedText(path, level);
        Path target = target(path);
        Path fresh = beside(target, ".tmp");
        Path backup = beside(target, ".bak");
        Path freshBackup = beside(target, ".bak.tmp");
        try {
            files.write(fresh, bytes, target);
            files.force(fresh);
            keepOld(target, freshBackup, backup);
            files.moveOver(fresh, target);
        } catch (IOException problem) {
            discard(fresh);
            discard(freshBackup);
            throw new LevelSaveException(path.toString(), AtomicFile.reason(problem), problem);
        }
        forceFolder(target);
    }

    static Path beside(Path file, String suffix) {
        return file.resolveSibling(file.getFileName() + suffix);
    }

    /** Returns the text; throws if reading it back would not give an equal level. */
    private static byte[] checkedText(Path path, Level level) {
        String file = path.toString();
        byte[] bytes = LevelJson.write(level).getBytes(StandardCharsets.UTF_8);
        if (!LevelJson.read(file, bytes).equals(level)) {
            throw new LevelSaveException(file, "its text does not read back as the same level", null);
        }
        return bytes;
    }

    private static Path target(Path path) {
        try {
            return AtomicFile.target(path);
        } catch (IOException problem) {
            throw new LevelSaveException(path.toString(), AtomicFile.reason(problem), problem);
        }
    }

    /** Keeps the old version as backup, unless it is damaged and a good backup exists. */
    private void keepOld(Path target, Path freshBackup, Path backup) throws IOException {
        if (!files.exists(target)) {
            return;
        }
        byte[] old = files.read(target, JsonTree.MAX_FILE_BYTES);
        if (JsonTree.read(old, new Problems()) == null) {
            return;
        }
        files.write(freshBackup, old, target);
        files.force(freshBackup);
        files.moveOver(freshBackup, backup);
    }

    private void discard(Path file) {
        try {
            files.deleteIfExists(file);
        } catch (IOException leftover) {
            // The next save overwrites it.
            return;
        }
    }

    /** Forces the folder if possible: the new file is complete already, and Windows cannot force folders. */
    private void forceFolder(Path target) {
        try {
            files.force(target.getParent());
        } catch (IOException refused) {
            return;
        }
    }
}
