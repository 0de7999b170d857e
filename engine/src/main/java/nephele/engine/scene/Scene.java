package nephele.engine.scene;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.MirrorFaces;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.scene.SceneMaterials.Surface;
import nephele.engine.scene.light.LevelLight;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.PunctualLightTable;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.engine.scene.light.bake.FaceFragment;
import nephele.engine.scene.light.bake.FaceFragments;
import nephele.engine.scene.light.bake.SkyVisibility;

/**
 * Everything drawable that is derived from a level; immutable.
 *
 * @param statics the shapes of the static geometry
 * @param solids the meshes of the static geometry
 * @param cut the faces of the level's solids; {@code null} if neither baked light nor mirrors need them
 * @param light {@code null} if no light of the sky reaches them and no light was baked
 * @param mirrors openings that never change, in the order of their ids
 * @param lights {@code null} if there is no punctual light
 */
public record Scene(
        Level level,
        AssetSource assets,
        StaticShapes statics,
        SceneMaterials materials,
        SolidGeometry solids,
        FaceFragments cut,
        BakedLight light,
        List<Opening> mirrors,
        PunctualLightTable lights) {
    /** Same as {@link #of(PlacedLevel, BakedLight)}, for a level from which nothing else is derived. */
    public static Scene of(Level level, AssetSource assets) {
        PlacedLevel placed = PlacedLevel.of(level, assets);
        return of(placed, LevelLight.of(placed, done -> {}));
    }

    /**
     * Derives the scene; bakes nothing.
     *
     * @param light the result of {@link LevelLight}
     * @throws nephele.engine.asset.AssetException naming a picture that is missing or cannot be used
     */
    public static Scene of(PlacedLevel placed, BakedLight light) {
        Level level = placed.level();
        StaticShapes statics = placed.statics();
        SceneMaterials materials = SceneMaterials.NONE.edited(level.materials(), placed.assets());
        FaceFragments cut = cut(placed, light, null);
        SolidGeometry geometry = SolidGeometry.of(statics, materials, visibility(light), cut);
        List<Opening> mirrors = of(level, statics, materials, cut);
        PunctualLightTable lights = PunctualLightTable.of(level, statics);
        return new Scene(level, placed.assets(), statics, materials, geometry, cut, light, mirrors, lights);
    }

    /**
     * Derives the scene of an edited level; unchanged parts stay the same objects. Bakes nothing: the former light is kept
     * as far as it fits.
     *
     * @param baked for this level or for an earlier one, {@code null} for that of this scene
     * @throws nephele.engine.asset.AssetException naming a picture that is missing or cannot be used
     */
    public Scene edited(PlacedLevel placed, BakedLight baked) {
        Level edited = placed.level();
        StaticShapes others = placed.statics();
        SceneMaterials otherMaterials = materials.edited(edited.materials(), placed.assets());
        BakedLight otherLight = light(edited, baked);
        FaceFragments otherCut = cut(placed, otherLight, cut);
        SolidGeometry geometry = solids.edited(others, otherMaterials, visibility(otherLight), otherCut);
        boolean areMirrorsSame = others.solids() == statics.solids() && otherMaterials == materials;
        List<Opening> otherMirrors = areMirrorsSame ? mirrors : of(edited, others, otherMaterials, otherCut);
        PunctualLightTable otherLights = PunctualLightTable.edited(lights, edited, others);
        return new Scene(
                edited,
                placed.assets(),
                others,
                otherMaterials,
                geometry,
                otherCut,
                otherLight,
                otherMirrors,
                otherLights);
    }

    private static SkyVisibility visibility(BakedLight light) {
        return light == null ? null : light.visibility();
    }

    private BakedLight light(Level edited, BakedLight baked) {
        BakedLight known = baked == null ? light : baked;
        if (LightRequirements.skyVisibility(edited)) {
            return known == null ? BakedLight.open() : known;
        }
        return known == null || known.indirect() == null ? null : known;
    }

    private static FaceFragments cut(PlacedLevel placed, BakedLight light, FaceFragments before) {
        if (light == null && !MirrorFaces.any(placed.level())) {
            return null;
        }
        FaceFragments known = before == null && light != null ? light.layout().fragments() : before;
        List<Brush> solids = placed.statics().solids();
        return known == null ? FaceFragments.of(solids) : known.edited(solids);
    }

    /**
     * Returns the mirrors of a level in the order of its faces.
     *
     * @param cut the faces of the level's solids, cut by each other
     */
    private static List<Opening> of(Level level, StaticShapes statics, SceneMaterials materials, FaceFragments cut) {
        if (!MirrorFaces.any(level)) {
            return List.of();
        }
        List<Brush> brushes = statics.solids();
        List<List<List<FaceFragment>>> fragments = cut.byBrush();
        List<Opening> mirrors = new ArrayList<>();
        for (int brush = 0; brush < brushes.size(); brush++) {
            for (int face = 0; face < brushes.get(brush).faces().size(); face++) {
                BrushFace said = brushes.get(brush).faces().get(face);
                Surface surface = materials.surfaces().get(materials.indexOf(said.material()));
                List<Vec3> polygon = surface.material().mirror()
                        ? visible(said, fragments.get(brush).get(face))
                        : List.of();
                if (!polygon.isEmpty()) {
                    Vec3 tint = surface.material().baseColour();
                    mirrors.add(Opening.ofMirror(
                            mirrors.size(), polygon, said.plane().normal(), tint));
                }
            }
        }
        return List.copyOf(mirrors);
    }

    /**
     * Returns the uncovered part of a face if it is a single convex fragment, the whole face if there are several (the
     * solids in front hide the rest), and nothing if the face is covered entirely.
     */
    private static List<Vec3> visible(BrushFace face, List<FaceFragment> fragments) {
        List<FaceFragment> seen =
                fragments.stream().filter(part -> !part.isCovered()).toList();
        if (seen.isEmpty()) {
            return List.of();
        }
        return seen.size() == 1 ? seen.get(0).outline() : face.polygon();
    }
}
