package nephele.engine.level.placed;

import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;

/**
 * A level with what follows from it for everybody: derived once, shared by scene, simulation, oracle and editor.
 *
 * @param statics the shapes of what never moves
 */
public record PlacedLevel(Level level, AssetSource assets, StaticShapes statics) {
    /** @throws nephele.engine.asset.AssetException naming a mesh that is missing or cannot be used */
    public static PlacedLevel of(Level level, AssetSource assets) {
        return new PlacedLevel(level, assets, StaticShapes.of(level, assets));
    }

    /** Derives an edited level: what does not differ stays the same object, solids and models by their records' identity. */
    public PlacedLevel edited(Level other) {
        return new PlacedLevel(other, assets, statics.edited(level, other, assets));
    }
}
