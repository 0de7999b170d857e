package nephele.engine.scene.light;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleConsumer;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Brush;
import nephele.engine.scene.SkyVisibility;

/**
 * Finds a baked sky visibility or bakes it. It is looked for as {@code cache/NAME} among the level's assets – beside the
 * level, or in the jar for the levels that come with the game – and then in the user's own cache folder; a new bake is
 * written to the first of the writable folders that takes it. A cache that cannot be written costs time, nothing else.
 *
 * @param writable in order of preference
 */
public record SkyVisibilityCache(AssetSource assets, List<Path> writable) {

    /** Beside a level where there is a folder, else in the user's cache. */
    public static SkyVisibilityCache of(AssetSource assets) {
        Path own = userFolder();
        return new SkyVisibilityCache(
                assets, assets.cacheFolder().map(beside -> List.of(beside, own)).orElse(List.of(own)));
    }

    private static Path userFolder() {
        String cache = System.getenv("XDG_CACHE_HOME");
        Path base = cache == null || cache.isBlank()
                ? Path.of(System.getProperty("user.home", "."), ".cache")
                : Path.of(cache);
        return base.resolve("nephele");
    }

    /** @param progress of a bake, 0–1; not called when nothing has to be baked */
    public SkyVisibility of(List<Brush> brushes, DoubleConsumer progress) {
        LightMapLayout layout = LightMapLayout.of(brushes);
        String name = SkyVisibilityFile.nameFor(brushes);
        Optional<short[]> known = stored(name).flatMap(bytes -> SkyVisibilityFile.decode(layout, bytes));
        if (known.isPresent()) {
            return new SkyVisibility(layout, known.get());
        }
        short[] texels = SkyVisibilityBake.texels(layout, brushes, progress);
        store(name, SkyVisibilityFile.encode(layout, texels));
        return new SkyVisibility(layout, texels);
    }

    private Optional<byte[]> stored(String name) {
        try {
            if (assets.exists("cache/" + name)) {
                return Optional.of(assets.bytes("cache/" + name));
            }
            for (Path folder : writable) {
                Path file = folder.resolve(name);
                if (Files.isRegularFile(file)) {
                    return Optional.of(Files.readAllBytes(file));
                }
            }
        } catch (IOException | AssetException e) {
            return Optional.empty();
        }
        return Optional.empty();
    }

    private void store(String name, byte[] bytes) {
        for (Path folder : writable) {
            try {
                Files.createDirectories(folder);
                Path temporary = Files.createTempFile(folder, name, ".tmp");
                Files.write(temporary, bytes);
                Files.move(temporary, folder.resolve(name), StandardCopyOption.REPLACE_EXISTING);
                return;
            } catch (IOException e) {
                // The next folder may be writable.
                continue;
            }
        }
    }
}
