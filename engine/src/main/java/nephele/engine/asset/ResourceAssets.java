package nephele.engine.asset;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;

/**
 * Assets in the jar, below one class-path folder such as {@code /assets}. Those of the checkout from which the start script
 * runs the jar come first, so that the jar needs no build when one of them changes.
 */
public final class ResourceAssets implements AssetSource {
    /** The environment variable in which the start script names the checkout. */
    static final String CHECKOUT = "NEPHELE_CHECKOUT";

    private final String folder;

    /** The same folder of the checkout; {@code null} for none. */
    private final FolderAssets checkout;

    /** @param folder absolute, without a trailing slash; empty for the root */
    public ResourceAssets(String folder) {
        this(folder, System.getenv(CHECKOUT));
    }

    /** @param checkout a folder with {@code levels}, {@code scenes} and {@code assets}; {@code null} for none */
    ResourceAssets(String folder, String checkout) {
        this.folder = folder;
        this.checkout = checkout == null || FileName.objection(checkout) != null
                ? null
                : new FolderAssets(Path.of(checkout + folder));
    }

    @Override
    public boolean exists(String assetId) {
        return AssetId.rejectionReason(assetId) == null
                && (isInCheckout(assetId) || ResourceAssets.class.getResource(name(assetId)) != null);
    }

    @Override
    public byte[] bytes(String assetId) {
        AssetId.check(assetId);
        if (isInCheckout(assetId)) {
            return checkout.bytes(assetId);
        }
        try (InputStream stream = ResourceAssets.class.getResourceAsStream(name(assetId))) {
            if (stream == null) {
                throw new AssetException(assetId, "is not in the jar's " + folder, "check the name");
            }
            return FolderAssets.readBounded(assetId, stream);
        } catch (IOException problem) {
            throw new AssetException(assetId, "cannot be read from the jar", "download or build the jar again");
        }
    }

    private boolean isInCheckout(String assetId) {
        return checkout != null && checkout.exists(assetId);
    }

    private String name(String assetId) {
        return folder + "/" + assetId;
    }
}
