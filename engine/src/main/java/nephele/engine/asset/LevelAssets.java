package nephele.engine.asset;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** A level's assets: the level's own folder first, then {@code assets/} of a checkout, then the jar's. */
public final class LevelAssets implements AssetSource {
    /** Where the jar keeps the levels that come with the game. */
    public static final String JAR_LEVELS = "/levels";

    private static final String JAR_ASSETS = "/assets";

    private final List<AssetSource> sources;

    private final Path folder;

    private LevelAssets(List<AssetSource> sources, Path folder) {
        this.sources = List.copyOf(sources);
        this.folder = folder;
    }

    /** For a level in the file system, which need not exist yet. */
    public static LevelAssets beside(Path levelFile) {
        Path folder = levelFile.toAbsolutePath().normalize().getParent();
        List<AssetSource> sources = new ArrayList<>();
        sources.add(new FolderAssets(folder));
        for (Path above = folder.getParent(); above != null; above = above.getParent()) {
            addCheckout(sources, above);
        }
        addCheckout(sources, Path.of("").toAbsolutePath());
        sources.add(new ResourceAssets(JAR_ASSETS));
        return new LevelAssets(sources, folder);
    }

    /** @param resource a level in the jar, below {@link #JAR_LEVELS}, such as {@code samples/sky.json} */
    public static LevelAssets inJar(String resource) {
        return inJar(JAR_LEVELS, resource);
    }

    /** @param resource a file in the jar, below {@code root}, such as {@code /scenes} */
    public static LevelAssets inJar(String root, String resource) {
        int slash = resource.lastIndexOf('/');
        String folder = slash < 0 ? root : root + "/" + resource.substring(0, slash);
        return new LevelAssets(List.of(new ResourceAssets(folder), new ResourceAssets(JAR_ASSETS)), null);
    }

    /** A checkout is a folder with {@code assets} beside {@code levels}. */
    private static void addCheckout(List<AssetSource> sources, Path folder) {
        if (Files.isDirectory(folder.resolve("assets")) && Files.isDirectory(folder.resolve("levels"))) {
            sources.add(new FolderAssets(folder.resolve("assets")));
        }
    }

    @Override
    public Optional<Path> cacheFolder() {
        return Optional.ofNullable(folder).map(beside -> beside.resolve("cache"));
    }

    @Override
    public boolean exists(String assetId) {
        return sources.stream().anyMatch(source -> source.exists(assetId));
    }

    @Override
    public byte[] bytes(String assetId) {
        AssetId.check(assetId);
        for (AssetSource source : sources) {
            if (source.exists(assetId)) {
                return source.bytes(assetId);
            }
        }
        throw new AssetException(
                assetId,
                "there is no such file",
                "put it into the level's folder or into assets/ (names are case-sensitive)");
    }
}
