package nephele.engine.scene;

import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;

/** Everything drawable that follows from a level; immutable. */
public record Scene(Level level, AssetSource assets, SceneMaterials materials, SolidGeometry solids) {
    /**
     * Derives the scene.
     *
     * @throws nephele.engine.asset.AssetException naming a picture that is missing or cannot be used
     */
    public static Scene of(Level level, AssetSource assets) {
        SceneMaterials materials = SceneMaterials.of(level.materials(), assets);
        return new Scene(level, assets, materials, SolidGeometry.of(level.solids(), materials));
    }
}
