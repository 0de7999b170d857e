package nephele.app.levels;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import nephele.app.terminal.CommandFailure;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.LevelAssets;
import nephele.engine.asset.ResourceAssets;

/**
 * A level that was named but not read: a file, or a resource of the jar.
 *
 * @param shown how messages call it
 * @param file null for a level in the jar
 * @param resource path below the jar's levels, null for a file
 */
public record LevelFile(String shown, Path file, String resource) {
    private static final int LARGEST_BYTES = 64 << 20;

    static LevelFile of(Path file) {
        return new LevelFile(file.toString(), file, null);
    }

    static LevelFile inJar(String resource) {
        return new LevelFile("levels/" + resource, null, resource);
    }

    /** The file's name without folder, number and ending: "01-first-light.json" is "First light". */
    public String title() {
        String name = shown.substring(Math.max(shown.lastIndexOf('/'), shown.lastIndexOf('\\')) + 1);
        String words =
                name.replaceFirst("\\.json$", "").replaceFirst("^[0-9]+-", "").replace('-', ' ');
        return words.isEmpty() ? name : Character.toUpperCase(words.charAt(0)) + words.substring(1);
    }

    public byte[] bytes() {
        if (file == null) {
            return new ResourceAssets(LevelAssets.JAR_LEVELS).bytes(resource);
        }
        try {
            if (Files.isDirectory(file)) {
                throw CommandFailure.input(shown + ": is a folder; name a level file, such as levels/01-*.json");
            }
            return bounded();
        } catch (IOException unreadable) {
            throw CommandFailure.input(
                    shown + ": can't be read (" + unreadable.getClass().getSimpleName() + "); check its permissions");
        }
    }

    private byte[] bounded() throws IOException {
        try (var stream = Files.newInputStream(file)) {
            byte[] bytes = stream.readNBytes(LARGEST_BYTES + 1);
            if (bytes.length > LARGEST_BYTES) {
                throw CommandFailure.input(shown + ": is larger than " + (LARGEST_BYTES >> 20) + " MiB");
            }
            return bytes;
        }
    }

    public AssetSource assets() {
        return file == null ? LevelAssets.inJar(resource) : LevelAssets.beside(file);
    }

    /** The level's recorded walk: the replay of {@code d/x.json} is {@code d/replays/x.json}. */
    public Optional<LevelFile> replay() {
        if (file != null) {
            var beside = file.toAbsolutePath().resolveSibling("replays").resolve(file.getFileName());
            return Files.isRegularFile(beside) ? Optional.of(of(beside)) : Optional.empty();
        }
        int slash = resource.lastIndexOf('/') + 1;
        var inJar = resource.substring(0, slash) + "replays/" + resource.substring(slash);
        boolean there = new ResourceAssets(LevelAssets.JAR_LEVELS).exists(inJar);
        return there ? Optional.of(inJar(inJar)) : Optional.empty();
    }
}
