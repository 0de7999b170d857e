package nephele.lab.trade.subject;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;

/** A level's assets together with files in memory, which a report makes. */
record AddedAssets(AssetSource rest, Map<String, byte[]> added) implements AssetSource {
    @Override
    public byte[] bytes(String assetId) throws AssetException {
        byte[] own = added.get(assetId);
        return own != null ? own : rest.bytes(assetId);
    }

    @Override
    public <T> T decoded(String assetId, Class<T> kind, BiFunction<String, byte[], T> decode) throws AssetException {
        byte[] own = added.get(assetId);
        return own != null ? decode.apply(assetId, own) : rest.decoded(assetId, kind, decode);
    }

    @Override
    public String objection(String assetId) {
        return rest.objection(assetId);
    }

    @Override
    public boolean exists(String assetId) {
        return added.containsKey(assetId) || rest.exists(assetId);
    }

    @Override
    public Optional<Path> levelFile() {
        return rest.levelFile();
    }

    @Override
    public Optional<Path> cacheFolder() {
        return rest.cacheFolder();
    }
}
