package nephele.engine.scene.light.bake;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleConsumer;
import java.util.stream.Stream;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.CacheFolder;
import nephele.engine.level.placed.StaticShapes;

/**
 * Finds baked light, and bakes a sky visibility that it does not find. Levels shipped with the game have theirs in {@code baked/} beside them, in
 * the checkout and in the jar; for others {@code cache/} beside the level and the user's own cache folder are searched.
 * A new bake is written to the first of these that is writable, which then deletes the least recently used files above
 * its limit. A cache that cannot be written only costs time.
 *
 * @param assets the level's assets, read for {@code baked/} and {@code cache/}
 * @param writable folders in order of preference
 */
public record LightCache(AssetSource assets, List<Path> writable) {
    /** The folder beside a level that is shipped with the game. */
    public static final String SHIPPED = "baked/";

    /** The folders beside a level, in the order in which they are searched. */
    public static final List<String> FOLDERS = List.of(SHIPPED, "cache/");

    /** The glob of the files' names. */
    private static final String NAMES = "{" + SkyVisibilityFile.NAMES + "," + LightKey.NAMES + "}";

    /** Suffices for some thousand sky visibilities, or some fifty levels with all their light. */
    private static final long MOST_BYTES = 64 << 20;

    /** Returns the cache in a folder beside the level if there is one, and in the user's cache folder. */
    public static LightCache of(AssetSource assets) {
        Path own = CacheFolder.ofUser();
        return new LightCache(
                assets, assets.cacheFolder().map(beside -> List.of(beside, own)).orElse(List.of(own)));
    }

    /**
     * Returns the stored or newly baked visibility.
     *
     * @param progress of a bake, 0–1; not called without a bake
     */
    public SkyVisibility of(StaticShapes statics, DoubleConsumer progress) {
        Optional<SkyVisibility> known = known(statics);
        if (known.isPresent()) {
            return known.get();
        }
        LightMapLayout layout = LightMapLayout.of(statics.solids());
        SkyVisibility visibility = SkyVisibility.bake(layout, statics, true, progress);
        store(SkyVisibilityFile.nameFor(statics), SkyVisibilityFile.encode(visibility));
        return visibility;
    }

    /** Returns the stored visibility; bakes nothing. */
    public Optional<SkyVisibility> known(StaticShapes statics) {
        return stored(SkyVisibilityFile.nameFor(statics))
                .flatMap(bytes -> SkyVisibilityFile.decode(LightMapLayout.of(statics.solids()), statics, bytes));
    }

    /**
     * Returns false if no file of a kind is in any of the folders, which spares the caller the hash of a level; true in the
     * jar, whose folders cannot be listed.
     *
     * @param names a glob
     */
    public boolean canHold(String names) {
        Path level = assets.levelFile().orElse(null);
        return level == null
                || Stream.concat(FOLDERS.stream().map(level::resolveSibling), writable.stream())
                        .anyMatch(folder -> holds(folder, names));
    }

    private static boolean holds(Path folder, String names) {
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, names)) {
            return files.iterator().hasNext();
        } catch (IOException none) {
            return false;
        }
    }

    /** Returns the bytes of a file of baked light. */
    public Optional<byte[]> stored(String name) {
        try {
            for (String folder : FOLDERS) {
                if (assets.exists(folder + name)) {
                    return Optional.of(assets.bytes(folder + name));
                }
            }
        } catch (AssetException e) {
            return Optional.empty();
        }
        return folders()
                .map(folder -> folder.find(name))
                .flatMap(Optional::stream)
                .findFirst();
    }

    private Stream<CacheFolder> folders() {
        return writable.stream().map(path -> new CacheFolder(path, NAMES, MOST_BYTES));
    }

    /** Writes a file to the first folder that can be written. */
    public void store(String name, byte[] bytes) {
        for (CacheFolder folder : folders().toList()) {
            try {
                folder.store(name, bytes);
                return;
            } catch (IOException e) {
                // The next folder may be writable.
                continue;
            }
        }
    }
}
