package nephele.engine.level.json;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import nephele.engine.asset.AssetId;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.LevelAssets;
import nephele.engine.asset.ResourceAssets;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;

/** Levels in files and in the jar. */
public final class LevelFile {
    private LevelFile() {}

    /**
     * A level with what belongs to it.
     *
     * @param file how messages call it
     * @param notice what the player should know about how it was found, such as that the backup stood in
     */
    public record Opened(String file, Level level, AssetSource assets, Optional<String> notice) {}

    /**
     * What a user typed: a file, or else a level of the jar, such as {@code levels/samples/sky.json}.
     *
     * @throws LevelFormatException when there is neither, or when it is no level
     */
    public static Opened open(String typed) throws LevelFormatException {
        Path path = path(typed);
        if (Files.exists(path) || Files.exists(LevelSaver.beside(path, ".bak"))) {
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

    /** Loads a file; when it is missing or not even JSON (a crash, a full disk), its {@code .bak} stands in. */
    public static Opened load(Path path) throws LevelFormatException {
        return load(path, FileOperations.REAL);
    }

    static Opened load(Path path, FileOperations files) {
        String file = path.toString();
        AssetSource assets = LevelAssets.beside(path);
        try {
            return new Opened(file, read(path, files), assets, Optional.empty());
        } catch (LevelFormatException problem) {
            Path backup = LevelSaver.beside(path, ".bak");
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

    /** Reads this file and no other: what {@code check} looks at. */
    public static Level read(Path path) throws LevelFormatException {
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
     * Saves so that a kill, a full disk or a power cut at any moment leaves the old or the new file complete; the
     * previous version stays as {@code .bak}.
     *
     * @throws LevelSaveException when it was not saved; the file is then untouched
     * @throws LevelFormatException when the level holds what a file must not; nothing was written
     */
    public static void save(Path path, Level level) throws LevelSaveException {
        new LevelSaver(FileOperations.REAL).save(path, level);
    }

    private static Path path(String typed) {
        try {
            return Path.of(typed);
        } catch (InvalidPathException problem) {
            throw new LevelFormatException(
                    typed.replaceAll("\\p{Cntrl}", "?"), List.of(Problem.error("$", "this is no file name")));
        }
    }
}
