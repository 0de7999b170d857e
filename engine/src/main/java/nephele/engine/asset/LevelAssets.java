package nephele.engine.asset;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** A level's assets: first the level's own folder, then {@code assets/} of a checkout, then the jar's. */
public final class LevelAssets implements AssetSource {
    /** The jar's folder of the levels that come with the game. */
    public static final String JAR_LEVELS = "/levels";

    private static final String JAR_ASSETS = "/assets";

    private final List<AssetSource> sources;

    /** {@code null} in the jar. */
    private final Path levelFile;

    private LevelAssets(List<AssetSource> sources, Path levelFile) {
        this.sources = List.copyOf(sources);
        this.levelFile = levelFile;
    }

    /** Returns the assets of a level in the file system; the level file need not exist yet. */
    public static LevelAssets beside(Path levelFile) {
        Path file = levelFile.toAbsolutePath().normalize();
        Path folder = file.getParent();
        List<AssetSource> sources = new ArrayList<>();
        sources.add(new FolderAssets(folder));
        for (Path above = folder.getParent(); above != null; above = above.getParent()) {
            addCheckout(sources, above);
        }
        addCheckout(sources, Path.of("").toAbsolutePath());
        sources.add(new ResourceAssets(JAR_ASSETS));
        return new LevelAssets(sources, file);
    }

    /**
     * Returns the assets of a level in the jar.
     *
     * @param resource below {@link #JAR_LEVELS}, such as {@code samples/sky.json}
     */
    public static LevelAssets inJar(String resource) {
        return inJar(JAR_LEVELS, resource);
    }

    /**
     * Returns the assets of a file in the jar.
     *
     * @param root a folder in the jar, such as {@code /scenes}
     * @param resource the file below {@code root}
     */
    public static LevelAssets inJar(String root, String resource) {
        int slash = resource.lastIndexOf('/');
        String folder = slash < 0 ? root : root + "/" + resource.substring(0, slash);
        return new LevelAssets(List.of(new ResourceAssets(folder), new ResourceAssets(JAR_ASSETS)), null);
    }

    /** Returns these assets, and behind them those of another source. */
    public LevelAssets or(AssetSource others) {
        List<AssetSource> all = new ArrayList<>(sources);
        all.add(others);
        return new LevelAssets(all, levelFile);
    }

    /** Returns the assets of another source, and behind them these. */
    public LevelAssets behind(AssetSource others) {
        List<AssetSource> all = new ArrayList<>(List.of(others));
        all.addAll(sources);
        return new LevelAssets(all, levelFile);
    }

    /** Adds the assets of a checkout, which is a folder with {@code assets} beside {@code levels}. */
    private static void addCheckout(List<AssetSource> sources, Path folder) {
        if (Files.isDirectory(folder.resolve("assets")) && Files.isDirectory(folder.resolve("levels"))) {
            sources.add(new FolderAssets(folder.resolve("assets")));
        }
    }

    /** Returns the files that the asset could be, whether or not they are there, in the order of preference. */
    public List<Path> places(String assetId) {
        List<Path> places = new ArrayList<>();
        for (AssetSource source : sources) {
            if (source instanceof FolderAssets folderAssets && AssetId.rejectionReason(assetId) == null) {
                places.add(folderAssets.place(assetId));
            }
        }
        return places;
    }

    @Override
    public Optional<Path> levelFile() {
        return Optional.ofNullable(levelFile);
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
