package nephele.engine.scene.light;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import nephele.engine.asset.AssetException;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShape.HeightGrid;
import nephele.engine.scene.light.bake.IndirectLight;
import nephele.engine.scene.light.bake.IndirectLightFile;
import nephele.engine.scene.light.bake.LightCache;
import nephele.engine.scene.light.bake.LightKey;
import nephele.engine.scene.light.bake.LightMapLayout;
import nephele.engine.scene.light.bake.SkyVisibilityFile;

/**
 * The baked light of a level as it was found on disk.
 *
 * @param file its name, or that of the file which is there in its place; of no file if it is {@link State#MISSING}
 * @param light {@code null} if it is not {@link State#BAKED}
 */
public record StoredLight(State state, String file, IndirectLight light) {
    private static final int HEAD_BYTES = 1024;

    /** Whether there is light that can be drawn, or why there is none. */
    public enum State {
        BAKED("is baked"),
        MISSING("is not baked"),
        STALE("is of another version of the level"),
        FOREIGN("is no file of baked light"),
        DAMAGED("is damaged");

        private final String text;

        State(String text) {
            this.text = text;
        }
    }

    /**
     * Reads the light. Where no light of any level is it costs nothing, in the jar a hash of the level's records.
     *
     * @param layout of the level's static geometry, models split; called only if there is a file
     */
    static StoredLight of(PlacedLevel placed, Supplier<LightMapLayout> layout) {
        LightCache cache = LightCache.of(placed.assets());
        if (!cache.canHold(LightKey.NAMES)) {
            return new StoredLight(State.MISSING, "", null);
        }
        LightKey key = LightKey.of(placed);
        Optional<byte[]> found = cache.stored(key.fileName());
        if (found.isEmpty()) {
            return former(placed)
                    .map(file -> new StoredLight(State.STALE, file, null))
                    .orElse(new StoredLight(State.MISSING, key.fileName(), null));
        }
        Optional<IndirectLightFile.Head> head = IndirectLightFile.head(found.get());
        if (head.isEmpty()) {
            return new StoredLight(State.FOREIGN, key.fileName(), null);
        }
        if (!IndirectLightFile.isWhole(found.get())) {
            return new StoredLight(State.DAMAGED, key.fileName(), null);
        }
        if (!isOf(head.get(), placed)) {
            return new StoredLight(State.STALE, key.fileName(), null);
        }
        return IndirectLightFile.decode(layout.get(), LevelLight.baked(placed), groundPoints(placed), found.get())
                .map(light -> new StoredLight(State.BAKED, key.fileName(), light))
                .orElse(new StoredLight(State.DAMAGED, key.fileName(), null));
    }

    private static boolean isOf(IndirectLightFile.Head head, PlacedLevel placed) {
        try {
            return Arrays.equals(head.content(), content(placed));
        } catch (AssetException unreadable) {
            return false;
        }
    }

    /**
     * Returns the bytes of the file of a level's light, {@link LightKey#fileName}.
     *
     * @throws nephele.engine.asset.AssetException if a file that the level names cannot be read
     */
    public static byte[] file(PlacedLevel placed, IndirectLight light) {
        var statics = LevelLight.baked(placed);
        var head = new IndirectLightFile.Head(levelName(placed), content(placed));
        return IndirectLightFile.encode(head, LightMapLayout.of(statics.solids()), light);
    }

    /** Returns what the light depends on, hashed, in hexadecimal digits. */
    public static String contentName(PlacedLevel placed) {
        return LightKey.of(placed).fileName() + " " + HexFormat.of().formatHex(content(placed));
    }

    private static byte[] content(PlacedLevel placed) {
        String geometry = SkyVisibilityFile.nameFor(LevelLight.baked(placed));
        return LightKey.of(placed).content(placed.assets(), geometry);
    }

    /** Returns the name of the level's file; empty for one in the jar. */
    private static String levelName(PlacedLevel placed) {
        return placed.assets()
                .levelFile()
                .map(file -> file.getFileName().toString())
                .orElse("");
    }

    private static List<Integer> groundPoints(PlacedLevel placed) {
        return placed.statics().ground().stream()
                .map(HeightGrid::field)
                .map(field -> TerrainSky.points(field.cellColumns()) * TerrainSky.points(field.cellRows()))
                .toList();
    }

    /** Returns the name of a file with light of another version of the level. */
    private static Optional<String> former(PlacedLevel placed) {
        Path level = placed.assets().levelFile().orElse(null);
        if (level == null) {
            return Optional.empty();
        }
        String name = levelName(placed);
        for (String folder : LightCache.FOLDERS) {
            try (DirectoryStream<Path> all = Files.newDirectoryStream(level.resolveSibling(folder), LightKey.NAMES)) {
                for (Path file : all) {
                    if (IndirectLightFile.head(start(file))
                            .filter(head -> head.levelFile().equals(name))
                            .isPresent()) {
                        return Optional.of(file.getFileName().toString());
                    }
                }
            } catch (IOException none) {
                continue;
            }
        }
        return Optional.empty();
    }

    private static byte[] start(Path file) throws IOException {
        try (InputStream from = Files.newInputStream(file)) {
            return from.readNBytes(HEAD_BYTES);
        }
    }

    /**
     * Returns one line about it that says what to do.
     *
     * @param level what a user types for the level
     */
    public String line(String level) {
        String again = "; `bake " + level + " --light` bakes it";
        return switch (state) {
            case BAKED -> "baked light: " + file;
            case MISSING -> "baked light: none" + again;
            default -> "baked light: " + file + " " + state.text + " and is ignored" + again + " anew";
        };
    }

    /** Returns a line about light that is there and ignored; empty if there is none or it is good. */
    public Optional<String> warning(String level) {
        return state == State.BAKED || state == State.MISSING
                ? Optional.empty()
                : Optional.of(level + ": " + line(level));
    }
}
