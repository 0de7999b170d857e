package nephele.host.named;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.LevelAssets;
import nephele.engine.asset.ResourceAssets;
import nephele.engine.level.Language;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.PackageContent;
import nephele.host.terminal.CommandFailure;

/**
 * Finds levels: the game's campaign and samples in {@code levels/} of the working directory, else in the jar, and those in
 * a user's folder.
 */
public final class LevelCatalogue {
    private static final String FOLDER = "levels/";
    private static final String CAMPAIGN = "campaign.json";
    private static final String SAMPLES = "samples.json";
    private static final int LARGEST_BYTES = 1 << 20;

    /** Bounds the time for a folder that is none of levels. */
    private static final int MOST_IN_FOLDER = 1000;

    /** Folders beside a level that hold other files. */
    private static final Set<String> OTHER_FOLDERS = Set.of("replays", "pictures", "baked", "cache");

    private LevelCatalogue() {}

    /**
     * Returns the level that a game starts with by default.
     *
     * @throws CommandFailure if there is none
     */
    public static LevelName first() {
        var all = campaign();
        if (all.isEmpty()) {
            throw CommandFailure.environment("no " + FOLDER + CAMPAIGN
                    + " with a level in the working directory or in the jar; name a level: nephele play LEVEL");
        }
        return all.get(0);
    }

    /**
     * Returns the campaign's levels in order; empty if there is no campaign.
     *
     * @throws LevelFormatException if the campaign's file is no campaign
     */
    public static List<LevelName> campaign() {
        return file().levels().stream()
                .map(level -> new LevelName(FOLDER + level))
                .toList();
    }

    /**
     * Returns the titles of the campaign's levels and of the samples.
     *
     * @throws LevelFormatException if the campaign's file is no campaign
     */
    public static LevelTitles titles() {
        Map<String, Map<Language, String>> byKey = new HashMap<>();
        file().titles().forEach((level, titles) -> byKey.put(new LevelName(FOLDER + level).key(), titles));
        return new LevelTitles(byKey, LevelCatalogue::samples);
    }

    private static Campaign file() {
        return bytes(CAMPAIGN)
                .map(bytes -> Campaign.read(FOLDER + CAMPAIGN, bytes))
                .orElse(new Campaign(List.of(), Map.of()));
    }

    /**
     * Returns the samples; no groups if there is no file of them.
     *
     * @throws LevelFormatException if that file is no list of samples
     */
    public static SampleCatalogue samples() {
        return bytes(SAMPLES)
                .map(bytes -> SampleCatalogue.read(FOLDER + SAMPLES, bytes))
                .orElse(new SampleCatalogue(List.of()));
    }

    /** Returns the level after another one in the campaign; empty after the last and for other levels. */
    public static Optional<LevelName> after(LevelName level) {
        var all = campaign();
        for (int i = 0; i + 1 < all.size(); i++) {
            if (all.get(i).key().equals(level.key())) {
                return Optional.of(all.get(i + 1));
            }
        }
        return Optional.empty();
    }

    /** Returns true for the name of a level's file: any JSON file but the lists of levels. */
    public static boolean isLevel(Path file) {
        String name = file.getFileName().toString();
        return name.endsWith(".json") && !name.equals(CAMPAIGN) && !name.equals(SAMPLES);
    }

    /** Returns a file of the working directory's {@code levels/}, else that of the jar. */
    private static Optional<byte[]> bytes(String name) {
        Path file = Path.of(FOLDER + name);
        if (Files.isRegularFile(file)) {
            try {
                return Optional.of(AtomicFile.read(file, LARGEST_BYTES));
            } catch (IOException unreadable) {
                throw CommandFailure.input(file + ": can't be read: " + AtomicFile.reason(unreadable));
            }
        }
        AssetSource levels = new ResourceAssets(LevelAssets.JAR_LEVELS);
        return levels.exists(name) ? Optional.of(levels.bytes(name)) : Optional.empty();
    }

    /**
     * Returns the levels in a user's folder, by name: its .json files and .zip packages first, then those in its folders,
     * into which the editor unpacks a package; empty if there is no such folder.
     */
    public static List<LevelName> in(Path folder) {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        List<Path> files = new ArrayList<>(entries(folder));
        for (Path entry : List.copyOf(files)) {
            if (Files.isDirectory(entry, LinkOption.NOFOLLOW_LINKS) && files.size() < MOST_IN_FOLDER) {
                files.addAll(entries(entry));
            }
        }
        return files.stream()
                .filter(file -> isLevel(folder, file))
                .limit(MOST_IN_FOLDER)
                .map(file -> new LevelName(file.toString()))
                .toList();
    }

    /** Returns what is in a folder, by name; nothing if it cannot be read, which hides no other folder. */
    private static List<Path> entries(Path folder) {
        try (Stream<Path> entries = Files.list(folder)) {
            return entries.sorted((a, b) -> a.toString().compareToIgnoreCase(b.toString()))
                    .limit(MOST_IN_FOLDER)
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
                && !OTHER_FOLDERS.contains(parent)
                && (isLevel(file) || PackageContent.isPackage(name))
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
