package nephele.engine.asset;

import java.nio.file.Path;
import java.util.Optional;

/** Where a level's pictures, meshes and grids come from. */
public interface AssetSource {
    /**
     * The whole content of an asset.
     *
     * @param assetId refused where there is an {@link #objection}
     * @throws AssetException when it is missing, unreadable, too large or outside of the source
     */
    byte[] bytes(String assetId) throws AssetException;

    /** Why a name is never looked for, or {@code null} where one is. */
    default String objection(String assetId) {
        return AssetId.objection(assetId);
    }

    /** Whether {@link #bytes} would find it. */
    boolean exists(String assetId);

    /** A folder that takes derived files which {@link #bytes} would then find below {@code cache/}; empty for none. */
    default Optional<Path> cacheFolder() {
        return Optional.empty();
    }
}
