package nephele.engine.asset;

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
}
