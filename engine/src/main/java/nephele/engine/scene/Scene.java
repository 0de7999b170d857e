package nephele.engine.scene;

import java.util.List;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.scene.light.BakedSky;
import nephele.engine.scene.light.SkyVisibility;

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
    /** As {@link #of(PlacedLevel, SkyVisibility)}, for a level that nobody else derives anything from. */
    public static Scene of(Level level, AssetSource assets) {
        PlacedLevel placed = PlacedLevel.of(level, assets);
        return of(placed, BakedSky.of(placed, done -> {}));
    }

    /**
     * Derives the scene; bakes nothing.
     *
     * @param visibility of {@link BakedSky}
     * @throws nephele.engine.asset.AssetException naming a picture that is missing or cannot be used
     */
    public static Scene of(PlacedLevel placed, SkyVisibility visibility) {
        Level level = placed.level();
        StaticShapes statics = placed.statics();
        SceneMaterials materials = SceneMaterials.of(level.materials(), placed.assets());
        StaticShapes lit = visibility == null ? statics : statics.split(SkyVisibility.MODEL_EDGE_METRES);
        SolidGeometry geometry = SolidGeometry.of(lit, materials, visibility);
        List<Opening> mirrors = Mirrors.of(level, statics, materials);
        return new Scene(level, placed.assets(), statics, materials, geometry, visibility, mirrors);
    }
}
