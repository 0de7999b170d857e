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

    /** The same place with something else about it; what never moves is derived anew only where it differs. */
    public PlacedLevel as(Level other) {
        boolean isSamePlace = other.solids().equals(level.solids())
                && other.models().equals(level.models())
                && other.materials().equals(level.materials());
        return isSamePlace ? new PlacedLevel(other, assets, statics) : of(other, assets);
    }
}
