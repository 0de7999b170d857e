package nephele.engine.level.placed;

import java.util.Map;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;

/** The assets of a test: the given ones, and models that the generator makes from their names. */
public record NoFiles(Map<String, byte[]> files) implements AssetSource {
    public static final NoFiles AT_ALL = new NoFiles(Map.of());

    @Override
    public byte[] bytes(String assetId) {
        if (!exists(assetId)) {
            throw new AssetException(assetId, "is missing", "add it to the test");
        }
        return files.get(assetId);
    }

    @Override
    public boolean exists(String assetId) {
        return files.containsKey(assetId);
    }
}
