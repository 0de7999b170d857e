package nephele.host.named;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import nephele.engine.level.json.PackageContent;

/**
 * The levels in a user's folder: its .json files and .zip packages, and those in its folders, into which the editor
 * unpacks a package.
 */
public final class OwnLevels {
    /** Bounds the time for a folder that is none of levels. */
    private static final int MOST = 1000;

    /** Folders beside a level that hold other files. */
    private static final Set<String> OTHER = Set.of("replays", "pictures", "baked", "cache");

    private OwnLevels() {}

    /** Returns the levels by name, those of the folder itself first; empty if there is no such folder. */
    public static List<LevelName> in(Path folder) {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        List<Path> files = new ArrayList<>(entries(folder));
        for (Path entry : List.copyOf(files)) {
            if (Files.isDirectory(entry, LinkOption.NOFOLLOW_LINKS) && files.size() < MOST) {
                files.addAll(entries(entry));
            }
        }
        return files.stream()
                .filter(file -> isLevel(folder, file))
                .limit(MOST)
                .map(file -> new LevelName(file.toString()))
                .toList();
    }

    /** Returns what is in a folder, by name; nothing if it cannot be read, which hides no other folder. */
    private static List<Path> entries(Path folder) {
        try (Stream<Path> entries = Files.list(folder)) {
            return entries.sorted((a, b) -> a.toString().compareToIgnoreCase(b.toString()))
                    .limit(MOST)
                    .toList();
        } catch (IOException | UncheckedIOException unreadable) {
            return List.of();
        }
    }

    private static boolean isLevel(Path folder, Path file) {
        String name = file.getFileName().toString();
        String parent = file.getParent().equals(folder)
                ? ""
                : file.getParent().getFileName().toString();
        return !name.startsWith(".")
                && !parent.startsWith(".")
                && !OTHER.contains(parent)
                && (LevelCatalogue.isLevel(file) || PackageContent.isPackage(name))
                && !Files.isDirectory(file, LinkOption.NOFOLLOW_LINKS);
    }

    /** Returns true if a level is in the folder. */
    public static boolean isIn(Path folder, LevelName level) {
        return Path.of(level.typed()).toAbsolutePath().normalize().startsWith(folder);
    }

    /** Returns a level's name within the folder. */
    public static String nameIn(Path folder, LevelName level) {
        return folder.relativize(Path.of(level.typed())).toString();
    }
}
