package nephele.engine.level.placed;

import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.Daylight;

/**
 * A level with all data derived once for scene, simulation, reference path tracer and editor.
 *
 * @param level with the sun of its hour
 * @param statics the static shapes
 */
public record PlacedLevel(Level level, AssetSource assets, StaticShapes statics) {
    /**
     * Derives the shapes and reads the meshes.
     *
     * @throws nephele.engine.asset.AssetException that names a mesh that is missing or cannot be used
     */
    public static PlacedLevel of(Level level, AssetSource assets) {
        return new PlacedLevel(Daylight.lit(level), assets, StaticShapes.of(level, assets));
    }

    /**
     * Derives an edited level; unchanged parts stay the same objects, solids and models by the identity of their
     * records.
     */
    public PlacedLevel edited(Level other) {
        return new PlacedLevel(Daylight.lit(other), assets, statics.edited(level, other, assets));
    }
}
