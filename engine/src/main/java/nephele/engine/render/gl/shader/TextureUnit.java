package nephele.engine.render.gl.shader;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The texture units, and for each the names of the samplers that read it in every program. OpenGL 4.1 guarantees that each shader of a program can read 16, and that there are 80.
 * Units with the same number belong to draws that never read both.
 */
public enum TextureUnit {
    /** Base colours of materials, or the only picture of a pass: sky faces, letters, a picture to be tone-mapped. */
    COLOURS(
            0,
            "cells",
            "checks",
            "clouds",
            "colours",
            "displayed",
            "faces",
            "histogram",
            "impostorColours",
            "letters",
            "linearPicture",
            "pictures",
            "openingPicture",
            "skyTable",
            "smallPicture",
            "sprites"),
    /** An image during allocation or replacement; draws bind their own afterwards. */
    UPLOAD(0),
    NORMALS(1, "normals"),
    /** The picture of the overlay, which is drawn together with its letters. */
    OVERLAY_PICTURE(1, "overlayPicture"),
    /** The edge mask of the edge filter. */
    EDGES(1, "edges"),
    /** The average of the frames before. */
    HISTORY(1, "history"),
    /** The cells of a cloud, which is drawn after all surfaces. */
    CLOUD_DENSITY(1, "cloudDensity"),
    CLOUD_LIGHT(2, "cloudLight"),
    SMALL_ANGLES(3, "smallAngles"),
    CLOUD_SHAPE(4, "shapeTable"),
    CLOUD_DETAIL(5, "detailTable"),
    CLOUD_PROFILE(6, "profileTable"),
    CLOUD_PLAN(10, "planTable"),
    /** The columns of a cloud that is drawn as a sheet, and has no plan. */
    CLOUD_COLUMNS(10, "sheetColumns"),
    CLOUD_LIGHT_TO_COME(9, "cloudLightToCome"),
    /** The pictures of a cloud that is drawn as a skybox, which has no cells then. */
    CLOUD_FACES(1, "bakedFaces"),
    CLOUD_FACES_BEFORE(2, "bakedBefore"),
    /** The picture of a slab of a cloud, and how far away it is. */
    IMPOSTOR(1, "impostor"),
    IMPOSTOR_PLACES(2, "impostorPlaces"),
    /** What {@code spread.frag} reads: rays of this frame, places of the clouds there, and the layer before. */
    SPREAD_FRESH(0, "fresh"),
    SPREAD_PLACES(1, "freshPlaces"),
    SPREAD_BEFORE(2, "before"),
    /** What shaders of {@code surface} read: clouds in front of the nearest and farthest surfaces of blocks of pixels. */
    SURFACE_ENDS(0, "surfaceEnds"),
    BEFORE_NEAREST(0, "beforeNearest"),
    BEFORE_FARTHEST(1, "beforeFarthest"),
    SURFACE_CUTS(11, "surfaceCuts"),
    SUN_SHADOW(2, "sunShadowMap"),
    LIGHT_SHADOW(3, "lightShadowMaps"),
    SKY_VISIBILITY(4, "skyVisibilityMap", "terrainSky"),
    PUNCTUAL_LIGHTS(5, "lightTexels"),
    LIGHT_GRID(6, "lightGridCells"),
    CLOUD_SHADE(8, "cloudShade"),
    /** Bound with each view. */
    AIR(7, "airTable"),
    /** The shadows of clouds in the air; bound with each view. */
    SHAFTS(14, "shaftTable"),
    /** The points of a bolt of lightning. */
    BOLT_POINTS(8, "boltPoints"),
    /** What clouds leave of the light of each point of a bolt; no other target of a pass has this unit. */
    BOLT_TRANSMITTANCE(9, "boltTransmittance"),
    /** The shade of clouds that {@code shaft.frag} reads. */
    SHAFT_SHADE(0, "shade"),
    DYNAMIC_INSTANCES(9, "dynamicInstances", "particles"),
    /** The tiles of a terrain that a view draws. */
    TERRAIN_TILES(9, "terrainTiles"),
    /** Billboards, which are drawn by shaders that read neither normal maps nor light maps. */
    BILLBOARDS(9, "billboards"),
    BILLBOARD_ORDER(1, "billboardOrder"),
    BILLBOARD_GROUPS(4, "billboardGroups"),
    /** Models that are drawn as impostors, by shaders that read neither normal maps nor light maps. */
    PLANTS(9, "plants"),
    PLANT_ORDER(1, "plantOrder"),
    PLANT_KINDS(4, "plantKinds"),
    /** Normals and depths of impostors, which are drawn before there are copies of a view. */
    IMPOSTOR_SHAPES(12, "impostorShapes"),
    DYNAMIC_SUN_SHADOW(10, "dynamicSunMap"),
    DYNAMIC_LIGHT_SHADOW(11, "dynamicLightMaps"),
    VIEW_DEPTH(12, "viewDepth"),
    VIEW_COLOUR(13, "viewColour"),
    /** The light that static geometry sends to moving things, billboards or plants, which read no copy of a view's colours. */
    BOUNCED_LIGHT(13, "bouncedLight"),
    /** The heights and slopes of a terrain, which is drawn before there are copies of a view. */
    TERRAIN_HEIGHTS(12, "terrainHeights"),
    TERRAIN_SLOPES(13, "terrainSlopes"),
    /** The painted layers of a terrain, whose program may read sixteen other textures, one of them in vertices; a shader can read 16. */
    TERRAIN_LAYERS(16, "layerMap"),
    /** The baked light of static faces, or of a terrain. */
    BAKED_LIGHT(17, "bakedLight"),
    /** The baked light of each vertex of the models, which are drawn before there are copies of a view. */
    MODEL_LIGHT(12, "modelLight"),
    /** The metered exposure, bound throughout a frame. */
    EXPOSURE(15, "exposure"),

    /** The following units are for XML scenes, whose draws use none of the units above. */
    SCENE_VISIBLE(0, "visibleModels"),
    SCENE_PLACES(1, "places"),
    SCENE_LOOKS(2, "looks"),
    SCENE_LIGHTS(3, "fixedLights"),
    SCENE_PICTURE(4, "picture");

    public static final int COUNT = 18;

    private static final Map<String, TextureUnit> BY_SAMPLER = Stream.of(values())
            .flatMap(unit -> unit.samplers.stream().map(name -> Map.entry(name, unit)))
            .collect(Collectors.toUnmodifiableMap(Map.Entry::getKey, Map.Entry::getValue));

    private final int number;
    private final List<String> samplers;

    TextureUnit(int number, String... samplers) {
        this.number = number;
        this.samplers = List.of(samplers);
    }

    /** Returns the unit that a sampler of a name reads; {@code null} for a name that no unit has. */
    static TextureUnit of(String sampler) {
        return BY_SAMPLER.get(sampler);
    }

    public int number() {
        return number;
    }
}
