package nephele.engine.level.placed;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.HeightMap;
import nephele.engine.asset.HeightMapFile;
import nephele.engine.asset.LayerMap;
import nephele.engine.level.Level;
import nephele.engine.level.Terrain;
import nephele.engine.level.terrain.LayerPaint;
import nephele.engine.level.terrain.TerrainField;
import nephele.engine.math.heightfield.HeightField;

/** Makes the height grids of a level's terrains. */
final class Grounds {
    private Grounds() {}

    static List<StaticShape.HeightGrid> of(Level level, AssetSource assets) {
        return edited(List.of(), level, assets);
    }

    /**
     * Returns the grids of an edited level; the list itself if nothing has changed, and the heights of terrains that only
     * look different or lie elsewhere.
     *
     * @throws nephele.engine.asset.AssetException that names a height or layer map that is missing or cannot be used
     */
    static List<StaticShape.HeightGrid> edited(List<StaticShape.HeightGrid> before, Level level, AssetSource assets) {
        List<Terrain> terrains = level.terrains();
        Map<String, HeightMap> maps = new HashMap<>();
        List<StaticShape.HeightGrid> grids = new ArrayList<>(terrains.size());
        for (int i = 0; i < terrains.size(); i++) {
            grids.add(grid(i, terrains.get(i), before, maps, assets));
        }
        return grids.equals(before) ? before : List.copyOf(grids);
    }

    private static StaticShape.HeightGrid grid(
            int index,
            Terrain said,
            List<StaticShape.HeightGrid> before,
            Map<String, HeightMap> maps,
            AssetSource assets) {
        for (StaticShape.HeightGrid known : before) {
            if (TerrainField.isSameShape(known.said(), said)) {
                boolean isAtSamePlace = known.said().centre().equals(said.centre());
                HeightField field = isAtSamePlace ? known.field() : TerrainField.moved(known.field(), said);
                boolean isSame = isAtSamePlace && known.index() == index && known.said() == said;
                return isSame ? known : new StaticShape.HeightGrid(index, said, field, painted(said, known, assets));
            }
        }
        HeightMap map = maps.computeIfAbsent(
                said.heightMap(), file -> assets.decoded(file, HeightMap.class, HeightMapFile::read));
        return edited(index, said, map, before, assets);
    }

    /** Returns a grid of other heights, from those of the same terrain before if there are some. */
    private static StaticShape.HeightGrid edited(
            int index, Terrain said, HeightMap map, List<StaticShape.HeightGrid> before, AssetSource assets) {
        for (StaticShape.HeightGrid known : before) {
            if (known.id().equals(said.id())) {
                HeightField field = TerrainField.edited(known.field(), said, map);
                return new StaticShape.HeightGrid(index, said, field, painted(said, known, assets));
            }
        }
        return new StaticShape.HeightGrid(index, said, TerrainField.of(said, map), LayerPaint.read(said, assets));
    }

    /** Returns the layer map of a terrain, if possible the object that it had before. */
    private static Optional<LayerMap> painted(Terrain said, StaticShape.HeightGrid known, AssetSource assets) {
        boolean isSame = Objects.equals(said.layerMap(), known.said().layerMap())
                && said.layers().size() == known.said().layers().size();
        return isSame ? known.painted() : LayerPaint.read(said, assets);
    }
}
