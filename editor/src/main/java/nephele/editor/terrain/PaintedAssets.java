package nephele.editor.terrain;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BiFunction;
import nephele.engine.asset.AssetSource;

/** The files of a level with the maps of a stroke that goes on, which are given without being decoded. */
public record PaintedAssets(PaintedMaps maps, AssetSource files) implements AssetSource {
    @Override
    public byte[] bytes(String assetId) {
        Optional<PaintedMaps.PaintedMap> map = maps.known(assetId);
        return map.isPresent() && !files.exists(assetId) ? map.get().file().get() : files.bytes(assetId);
    }

    @Override
    public <T> T decoded(String assetId, Class<T> kind, BiFunction<String, byte[], T> decode) {
        return maps.known(assetId)
                .map(PaintedMaps.PaintedMap::decoded)
                .filter(kind::isInstance)
                .map(kind::cast)
                .orElseGet(() -> files.decoded(assetId, kind, decode));
    }

    @Override
    public String objection(String assetId) {
        return files.objection(assetId);
    }

    @Override
    public boolean exists(String assetId) {
        return maps.known(assetId).isPresent() || files.exists(assetId);
    }

    @Override
    public Optional<Path> levelFile() {
        return files.levelFile();
    }

    @Override
    public Optional<Path> cacheFolder() {
        return files.cacheFolder();
    }
}
