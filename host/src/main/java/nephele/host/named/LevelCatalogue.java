package nephele.host.named;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.LevelAssets;
import nephele.engine.asset.ResourceAssets;
import nephele.engine.level.Language;
import nephele.engine.level.json.LevelFormatException;
import nephele.host.terminal.CommandFailure;

/** Finds the game's levels: the campaign in {@code levels/} of the working directory, else the one in the jar. */
public final class LevelCatalogue {
    private static final String FOLDER = "levels/";
    private static final String CAMPAIGN = "campaign.json";
    private static final String SAMPLES = "samples.json";
    private static final int LARGEST_BYTES = 1 << 20;

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
}
