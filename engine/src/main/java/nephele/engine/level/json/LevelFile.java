package nephele.engine.level.json;

import java.io.IOException;
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

    private static Opened unpacked(String typed, Path zip) {
        try {
            PackageContent content = PackageContent.read(zip);
            var assets = new Unpacked(content.assets(), LevelAssets.beside(zip));
            return new Opened(typed, content.level(), assets, Optional.empty());
        } catch (PackageContent.Refused refused) {
            String place = refused.entry().orElse("$");
            String remedy = "; ask its author for a new export, or name a .zip that the editor exported";
            throw new LevelFormatException(typed, List.of(Problem.error(place, refused.getMessage() + remedy)));
        }
    }

    /** The assets in a package, and behind them those that a level beside it would have: the game's and the derived ones. */
    private record Unpacked(AssetSource inside, AssetSource beside) implements AssetSource {
        @Override
        public byte[] bytes(String assetId) {
            return (inside.exists(assetId) ? inside : beside).bytes(assetId);
        }

        @Override
        public boolean exists(String assetId) {
            return inside.exists(assetId) || beside.exists(assetId);
        }

        @Override
        public Optional<Path> cacheFolder() {
            return beside.cacheFolder();
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

    /** Saves through other file operations, as tests do that let one of them fail. */
    public static void save(Path path, Level level, FileOperations files) throws LevelSaveException {
        new LevelSaver(files).save(path, level);
    }

    private static Path path(String typed) {
        String objection = FileName.objection(typed);
        if (objection != null) {
            throw new LevelFormatException(FileName.printable(typed), List.of(Problem.error("$", objection)));
        }
        return Path.of(typed);
    }
}
