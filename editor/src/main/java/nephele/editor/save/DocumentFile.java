package nephele.editor.save;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.FileName;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.ToneCurve;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.math.Vec3;

/**
 * The file of a document, and its content when the document was opened or last saved.
 *
 * @param path absolute; empty for a document that was never saved
 * @param sha256 of that content; empty if there was none
 */
public record DocumentFile(Optional<Path> path, String sha256) {
    /** The file of a document that was never saved. */
    public static final DocumentFile UNTITLED = new DocumentFile(Optional.empty(), "");

    /** The file on disk compared with what was opened or saved. */
    public enum Outside {
        SAME,
        CHANGED,
        DELETED
    }

    /**
     * An opened level.
     *
     * @param notice a message about the source, such as that the previous version was used
     */
    public record Opened(DocumentFile file, Level level, AssetSource assets, Optional<String> notice) {}

    /**
     * Opens what a user typed: a file, or else a level of the jar, which is then an untitled document.
     *
     * @throws LevelFormatException if there is neither, or if it is no level
     */
    public static Opened open(String typed) throws LevelFormatException {
        // Hashed before it is read: a change between the two is then noticed at the next save.
        DocumentFile file = typedPath(typed).map(DocumentFile::at).orElse(UNTITLED);
        LevelFile.Opened read = LevelFile.open(typed);
        return new Opened(file, read.level(), read.assets(), read.notice());
    }

    private static Optional<Path> typedPath(String typed) {
        if (FileName.objection(typed) != null) {
            return Optional.empty();
        }
        Path path = Path.of(typed).toAbsolutePath().normalize();
        boolean isThere = Files.exists(path) || Files.exists(path.resolveSibling(path.getFileName() + ".bak"));
        return Optional.of(path).filter(file -> isThere);
    }

    private static DocumentFile at(Path path) {
        return new DocumentFile(Optional.of(path), hash(path));
    }

    /** Returns the file of a document that was just saved with this content. */
    static DocumentFile saved(Path path, byte[] content) {
        return new DocumentFile(Optional.of(path.toAbsolutePath().normalize()), ContentHash.of(content));
    }

    /** Returns this file with the content that it has at this moment. */
    public DocumentFile asOfNow() {
        return path.map(DocumentFile::at).orElse(this);
    }

    /** Compares the file on disk, by content, with what was opened or saved. An untitled document has the same file. */
    public Outside outside() {
        if (path.isEmpty()) {
            return Outside.SAME;
        }
        if (!Files.exists(path.get())) {
            return Outside.DELETED;
        }
        return hash(path.get()).equals(sha256) ? Outside.SAME : Outside.CHANGED;
    }

    /** Returns no hash for a file that cannot be read, so that it differs from every opened one. */
    private static String hash(Path path) {
        try {
            return ContentHash.of(path);
        } catch (IOException unreadable) {
            return "";
        }
    }

    /** Returns an untitled level with nothing in it but daylight; its assets are those of the working folder. */
    public static Opened untitled() {
        var sun = new Sun(new Vec3(-0.5, 0.75, 0.43), new Vec3(3.4, 3.1, 2.6), true);
        var sky = new Sky.Gradient(new Vec3(0.1, 0.24, 0.56), new Vec3(0.5, 0.6, 0.7), new Vec3(0.26, 0.24, 0.21));
        // Even light inside: a room without lamps is not black while it is built, and needs no bake.
        var inside = new Vec3(0.2, 0.22, 0.25);
        var environment = new Environment(sun, sky, inside, Exposure.NEUTRAL, ToneCurve.FILMIC, null, List.of());
        return new DocumentFile.Opened(
                DocumentFile.UNTITLED,
                Level.of("Untitled", "", environment, List.of()),
                LevelAssets.beside(Path.of("untitled.json")),
                Optional.empty());
    }
}
