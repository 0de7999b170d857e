package nephele.engine.scene;

import java.util.List;
import java.util.function.DoubleConsumer;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.scene.light.LightMapLayout;
import nephele.engine.scene.light.LightNeeds;
import nephele.engine.scene.light.SkyVisibility;
import nephele.engine.scene.light.SkyVisibilityCache;

/**
 * Everything drawable that follows from a level; immutable.
 *
 * @param skyVisibility {@code null} where no light of the sky falls on solids
 */
public record Scene(
        Level level, AssetSource assets, SceneMaterials materials, SolidGeometry solids, SkyVisibility skyVisibility) {
    /**
     * Derives the scene.
     *
     * @throws nephele.engine.asset.AssetException naming a picture that is missing or cannot be used
     */
    public static Scene of(Level level, AssetSource assets) {
        return of(level, assets, done -> {});
    }

    /** @param bakeProgress the done fraction, 0–1, of a bake of sky visibility; not called where none is due */
    public static Scene of(Level level, AssetSource assets, DoubleConsumer bakeProgress) {
        SceneMaterials materials = SceneMaterials.of(level.materials(), assets);
        SkyVisibility visibility = null;
        if (LightNeeds.skyVisibility(level)) {
            List<Brush> brushes = level.solids().stream().map(Brush::of).toList();
            visibility = SkyVisibilityCache.of(assets).of(brushes, bakeProgress);
        }
        LightMapLayout layout = visibility == null ? null : visibility.layout();
        return new Scene(level, assets, materials, SolidGeometry.of(level.solids(), materials, layout), visibility);
    }
}
