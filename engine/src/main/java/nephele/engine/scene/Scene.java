package nephele.engine.scene;

import java.util.List;
import java.util.function.DoubleConsumer;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.scene.light.LightNeeds;
import nephele.engine.scene.light.SkyVisibility;
import nephele.engine.scene.light.SkyVisibilityCache;

/**
 * Everything drawable that follows from a level; immutable.
 *
 * @param statics the shapes of what never moves
 * @param solids the same to be drawn
 * @param skyVisibility {@code null} where no light of the sky falls on them
 * @param mirrors openings that never change, in the order of their ids
 */
public record Scene(
        Level level,
        AssetSource assets,
        StaticShapes statics,
        SceneMaterials materials,
        SolidGeometry solids,
        SkyVisibility skyVisibility,
        List<Opening> mirrors) {
    /**
     * Derives the scene.
     *
     * @throws nephele.engine.asset.AssetException naming a picture or a mesh that is missing or cannot be used
     */
    public static Scene of(Level level, AssetSource assets) {
        return of(level, assets, done -> {});
    }

    /** @param bakeProgress the done fraction, 0–1, of a bake of sky visibility; not called where none is due */
    public static Scene of(Level level, AssetSource assets, DoubleConsumer bakeProgress) {
        return of(level, StaticShapes.of(level, assets), assets, bakeProgress);
    }

    /** The same for static shapes that were derived from the level before. */
    public static Scene of(Level level, StaticShapes statics, AssetSource assets, DoubleConsumer bakeProgress) {
        SceneMaterials materials = SceneMaterials.of(level.materials(), assets);
        List<Opening> mirrors = Mirrors.of(level, statics, materials);
        if (!LightNeeds.skyVisibility(level)) {
            SolidGeometry bare = SolidGeometry.of(statics, materials, null);
            return new Scene(level, assets, statics, materials, bare, null, mirrors);
        }
        StaticShapes split = statics.split(SkyVisibility.MODEL_EDGE_METRES);
        SkyVisibility visibility = SkyVisibilityCache.of(assets).of(split, bakeProgress);
        SolidGeometry geometry = SolidGeometry.of(split, materials, visibility);
        return new Scene(level, assets, statics, materials, geometry, visibility, mirrors);
    }
}
