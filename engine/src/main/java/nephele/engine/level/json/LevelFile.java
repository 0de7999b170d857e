package nephele.engine.level.json;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import nephele.engine.asset.AssetId;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.FileName;
import nephele.engine.asset.LevelAssets;
import nephele.engine.asset.ResourceAssets;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.work.SwingThread;

/** Loads and saves levels, from files and from the jar. */
public final class LevelFile {
    private LevelFile() {}

    /**
     * A level and its source.
     *
     * @param file its name in messages
     * @param notice a message to the player about the source, for example that the backup was used
     */
    public record Opened(String file, Level level, AssetSource assets, Optional<String> notice) {}

    /**
     * Opens what a user typed: a file, a package that the editor exported, or else a level of the jar, such as {@code
     * levels/samples/sky.json}.
     *
     * @throws LevelFormatException if there is neither, or if it is no level
     */
    public static Opened open(String typed) throws LevelFormatException {
        SwingThread.refuse("reading a level");
        Path path = path(typed);
        if (PackageContent.isPackage(typed)) {
            return unpacked(typed, path);
        }
        if (Files.exists(path) || Files.exists(beside(path, ".bak"))) {
            return load(path);
        }
        String name = typed.replace('\\', '/').replaceFirst("^(\\./)?levels/", "");
        AssetSource levels = new ResourceAssets(LevelAssets.JAR_LEVELS);
        if (AssetId.rejectionReason(name) == null && levels.exists(name)) {
            return new Opened(
                    typed, LevelJson.read(typed, levels.bytes(name)), LevelAssets.inJar(name), Optional.empty());
        }
        return load(path);
    }

    private static Opened unpacked(String typed, Path zip) {
        try {
            PackageContent content = PackageContent.read(zip);
            LevelAssets assets = LevelAssets.beside(zip).behind(content.assets());
            return new Opened(typed, content.level(), assets, Optional.empty());
        } catch (PackageContent.Refused refused) {
            String place = refused.entry().orElse("$");
            String remedy = "; ask its author for a new export, or name a .zip that the editor exported";
            throw new LevelFormatException(typed, List.of(Problem.error(place, refused.getMessage() + remedy)));
        }
    }

    /** Loads a file; if it is missing or no JSON at all (after a crash or on a full disk), loads its {@code .bak}. */
    public static Opened load(Path path) throws LevelFormatException {
        SwingThread.refuse("reading a level");
        return load(path, FileOperations.REAL);
    }

    static Opened load(Path path, FileOperations files) {
        String file = path.toString();
        AssetSource assets = LevelAssets.beside(path);
        try {
            return new Opened(file, read(path, files), assets, Optional.empty());
        } catch (LevelFormatException problem) {
            Path backup = beside(path, ".bak");
            if (!problem.isDamage() || !files.exists(backup)) {
                throw problem;
            }
            String notice = problem.problems().get(0).line(file) + "; the previous version " + backup + " is used";
            try {
                return new Opened(file, read(backup, files), assets, Optional.of(notice));
            } catch (LevelFormatException alsoBad) {
                throw problem;
            }
        }
    }

    /** Reads this file and never its backup, as {@code check} needs. */
    public static Level read(Path path) throws LevelFormatException {
        SwingThread.refuse("reading a level");
        return read(path, FileOperations.REAL);
    }

    private static Level read(Path path, FileOperations files) {
        String file = path.toString();
        try {
            return LevelJson.read(file, files.read(path, JsonTree.MAX_FILE_BYTES));
        } catch (IOException problem) {
            String reason =
                    Files.isDirectory(path) ? "this is a folder, name a level file in it" : AtomicFile.reason(problem);
            throw LevelFormatException.damage(file, List.of(Problem.error("$", "cannot be read: " + reason)));
        }
    }

    /**
     * Saves so that after a kill, a full disk or a power failure at any moment the old or the new file is complete; the
     * previous version stays as {@code .bak}.
     *
     * @throws LevelSaveException if it was not saved; the file is then unchanged
     * @throws LevelFormatException if the level contains values that a file must not; nothing was written
     */
    public static void save(Path path, Level level) throws LevelSaveException {
        save(path, level, FileOperations.REAL);
    }

    /**
     * Saves through other file operations, as tests do that let one of them fail: it writes the new content to a file
     * beside the old one, forces it to disk and renames it over the old one atomically (Pillai et al., OSDI 2014, on why
     * each step is needed).
     */
    public static void save(Path path, Level level, FileOperations files) throws LevelSaveException {
        byte[] bytes = checkedText(path, level);
        Path target = target(path);
        Path fresh = beside(target, ".tmp");
        Path backup = beside(target, ".bak");
        Path freshBackup = beside(target, ".bak.tmp");
        try {
            files.write(fresh, bytes, target);
            files.force(fresh);
            keepOld(files, target, freshBackup, backup);
            files.moveOver(fresh, target);
        } catch (IOException problem) {
            discard(files, fresh);
            discard(files, freshBackup);
            throw new LevelSaveException(path.toString(), AtomicFile.reason(problem), problem);
        }
        forceFolder(files, target);
    }

    private static Path beside(Path file, String suffix) {
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
    private static void keepOld(FileOperations files, Path target, Path freshBackup, Path backup) throws IOException {
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

    private static void discard(FileOperations files, Path file) {
        try {
            files.deleteIfExists(file);
        } catch (IOException leftover) {
            // The next save overwrites it.
            return;
        }
    }

    /** Forces the folder if possible: the new file is complete already, and Windows cannot force folders. */
    private static void forceFolder(FileOperations files, Path target) {
        try {
            files.force(target.getParent());
        } catch (IOException refused) {
            return;
        }
    }

    private static Path path(String typed) {
        String objection = FileName.objection(typed);
        if (objection != null) {
            throw new LevelFormatException(FileName.printable(typed), List.of(Problem.error("$", objection)));
        }
        return Path.of(typed);
    }
}
