package nephele.engine.asset;

import java.io.IOException;
import java.io.InputStream;

/** Assets in the jar, below one class-path folder such as {@code /assets}. */
public final class ResourceAssets implements AssetSource {
    private final String folder;

    /** @param folder absolute, without a trailing slash; empty for the root */
    public ResourceAssets(String folder) {
        this.folder = folder;
    }

    @Override
    public boolean exists(String assetId) {
        return AssetId.rejectionReason(assetId) == null && ResourceAssets.class.getResource(name(assetId)) != null;
    }

    @Override
    public byte[] bytes(String assetId) {
        AssetId.check(assetId);
        try (InputStream stream = ResourceAssets.class.getResourceAsStream(name(assetId))) {
            if (stream == null) {
                throw new AssetException(assetId, "is not in the jar's " + folder, "check the name");
            }
            return AssetLimits.readBounded(assetId, stream);
        } catch (IOException problem) {
            throw new AssetException(assetId, "cannot be read from the jar", "download or build the jar again");
        }
    }

    private String name(String assetId) {
        return folder + "/" + assetId;
    }
}
