package nephele.editor.terrain;

import java.util.function.Supplier;
import nephele.engine.asset.HeightMap;
import nephele.engine.asset.HeightMapFile;
import nephele.engine.asset.LayerMap;
import nephele.engine.asset.LayerMapFile;

/**
 * A map that a stroke has made.
 *
 * @param decoded what its file decodes to
 * @param file makes the file
 */
record PaintedMap(Object decoded, Supplier<byte[]> file) {
    static PaintedMap of(HeightMap map) {
        return new PaintedMap(map, () -> HeightMapFile.png(map));
    }

    static PaintedMap of(LayerMap map) {
        return new PaintedMap(map, () -> LayerMapFile.png(map));
    }
}
