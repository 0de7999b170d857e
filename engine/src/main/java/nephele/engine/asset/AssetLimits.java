package nephele.engine.asset;

import java.io.IOException;
import java.io.InputStream;

/** The size limit of assets, enforced before their content is parsed. */
final class AssetLimits {
    /** Maximum bytes of any asset file; raw heights of 8193 x 8193 samples need a little more than 128 MiB. */
    static final int MAX_FILE_BYTES = 129 << 20;

    private AssetLimits() {}

    /**
     * Reads a stream to its end and closes it; throws if it has more than {@link #MAX_FILE_BYTES}, without reading on.
     */
    static byte[] readBounded(String assetId, InputStream stream) throws IOException {
        try (stream) {
            byte[] bytes = stream.readNBytes(MAX_FILE_BYTES + 1);
            if (bytes.length > MAX_FILE_BYTES) {
                throw new AssetException(
                        assetId, "is larger than " + (MAX_FILE_BYTES >> 20) + " MiB", "make it smaller");
            }
            return bytes;
        } catch (OutOfMemoryError tooLarge) {
            throw new AssetException(assetId, "does not fit into memory", "make it smaller");
        }
    }
}
