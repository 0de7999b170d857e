package nephele.engine.asset;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BiFunction;

/** A source of a level's pictures, meshes and grids. */
public interface AssetSource {
    /**
     * Returns the whole content of an asset.
     *
     * @param assetId rejected if it has an {@link #objection}
     * @throws AssetException if the asset is missing, unreadable, too large or outside of the source
     */
    byte[] bytes(String assetId) throws AssetException;

    /**
     * Returns what an asset decodes to. A source may know it without its bytes.
     *
     * @param decode from the id, which names the asset in errors, and the bytes
     * @throws AssetException as {@link #bytes} and {@code decode} do
     */
    default <T> T decoded(String assetId, Class<T> kind, BiFunction<String, byte[], T> decode) throws AssetException {
        return decode.apply(assetId, bytes(assetId));
    }

    /** Returns the reason why a name is never looked up, or {@code null} if it is. */
    default String objection(String assetId) {
        return AssetId.rejectionReason(assetId);
    }

    /** Returns true if {@link #bytes} would find the asset. */
    boolean exists(String assetId);

    /** Returns the file of the level whose assets these are; empty for one in the jar. */
    default Optional<Path> levelFile() {
        return Optional.empty();
    }

    /** Returns a folder for derived files, which {@link #bytes} then finds below {@code cache/}; empty for none. */
    default Optional<Path> cacheFolder() {
        return levelFile().map(file -> file.resolveSibling("cache"));
    }
}
