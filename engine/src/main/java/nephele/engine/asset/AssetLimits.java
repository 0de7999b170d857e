package nephele.engine.asset;

import java.io.IOException;
import java.io.InputStream;

/** How large an asset may be before anything looks into it. */
final class AssetLimits {
    /** Bytes of any asset file. */
    static final int MAX_FILE_BYTES = 128 << 20;

    private AssetLimits() {}

    /** Reads to the end and closes; refuses more than {@link #MAX_FILE_BYTES} without reading on. */
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
