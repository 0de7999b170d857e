package nephele.engine.asset;

import java.nio.file.Path;
import java.util.Optional;

/** Where a level's pictures, meshes and grids come from. */
public interface AssetSource {
    /**
     * The whole content of an asset.
     *
     * @param assetId keeps to {@link AssetId}'s grammar, or the asset is refused
     * @throws AssetException when it is missing, unreadable, too large or outside of the source
     */
    byte[] bytes(String assetId) throws AssetException;

    /** Whether {@link #bytes} would find it. */
    boolean exists(String assetId);

    /** A folder that takes derived files which {@link #bytes} would then find below {@code cache/}; empty for none. */
    default Optional<Path> cacheFolder() {
        return Optional.empty();
    }
}
