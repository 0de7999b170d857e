package nephele.engine.render.gl.shader;

/**
 * The assignment of texture units. OpenGL 4.1 guarantees that each shader of a program can read 16, and that there are 80.
 * Units with the same number belong to draws that never read both.
 */
public enum TextureUnit {
    /** Base colours of materials, or the only picture of a pass: sky faces, letters, a picture to be tone-mapped. */
    COLOURS(0),
    /** An image during allocation or replacement; draws bind their own afterwards. */
    UPLOAD(0),
    NORMALS(1),
    /** The picture of the overlay, which is drawn together with its letters. */
    OVERLAY_PICTURE(1),
    /** The edge mask of the edge filter. */
    EDGES(1),
    /** The cells of a cloud, which is drawn after all surfaces. */
    CLOUD_DENSITY(1),
    CLOUD_LIGHT(2),
    SMALL_ANGLES(3),
    CLOUD_SHAPE(4),
    CLOUD_DETAIL(5),
    CLOUD_PROFILE(6),
    CLOUD_PLAN(10),
    /** The columns of a cloud that is drawn as a sheet, and has no plan. */
    CLOUD_COLUMNS(10),
    CLOUD_LIGHT_TO_COME(9),
    /** The pictures of a cloud that is drawn as a skybox, which has no cells then. */
    CLOUD_FACES(1),
    CLOUD_FACES_BEFORE(2),
    /** The picture of a slab of a cloud, and how far away it is. */
    IMPOSTOR(1),
    IMPOSTOR_PLACES(2),
    /** What {@code spread.frag} reads: rays of this frame, places of the clouds there, and the layer before. */
    SPREAD_FRESH(0),
    SPREAD_PLACES(1),
    SPREAD_BEFORE(2),
    SUN_SHADOW(2),
    LIGHT_SHADOW(3),
    SKY_VISIBILITY(4),
    PUNCTUAL_LIGHTS(5),
    LIGHT_GRID(6),
    CLOUD_SHADE(8),
    /** Bound with each view; {@link Uniforms} assigns it to its sampler. */
    AIR(7),
    /** The shadows of clouds in the air; bound and assigned as {@link #AIR} is. */
    SHAFTS(14),
    /** The points of a bolt of lightning. */
    BOLT_POINTS(8),
    /** What clouds leave of the light of each point of a bolt; no other target of a pass has this unit. */
    BOLT_TRANSMITTANCE(9),
    /** The shade of clouds that {@code shaft.frag} reads. */
    SHAFT_SHADE(0),
    DYNAMIC_INSTANCES(9),
    /** The tiles of a terrain that a view draws. */
    TERRAIN_TILES(9),
    /** Billboards, which are drawn by shaders that read neither normal maps nor light maps. */
    BILLBOARDS(9),
    BILLBOARD_ORDER(1),
    BILLBOARD_GROUPS(4),
    /** Models that are drawn as impostors, by shaders that read neither normal maps nor light maps. */
    PLANTS(9),
    PLANT_ORDER(1),
    PLANT_KINDS(4),
    /** Normals and depths of impostors, which are drawn before there are copies of a view. */
    IMPOSTOR_SHAPES(12),
    DYNAMIC_SUN_SHADOW(10),
    DYNAMIC_LIGHT_SHADOW(11),
    VIEW_DEPTH(12),
    VIEW_COLOUR(13),
    /** The heights and slopes of a terrain, which is drawn before there are copies of a view. */
    TERRAIN_HEIGHTS(12),
    TERRAIN_SLOPES(13),
    /** The painted layers of a terrain, whose program may read fifteen other textures; a shader can read 16. */
    TERRAIN_LAYERS(16),
    /** The metered exposure, bound throughout a frame. */
    EXPOSURE(15),

    /** The following units are for XML scenes, whose draws use none of the units above. */
    SCENE_VISIBLE(0),
    SCENE_PLACES(1),
    SCENE_LOOKS(2),
    SCENE_LIGHTS(3),
    SCENE_PICTURE(4);

    public static final int COUNT = 17;

    private final int number;

    TextureUnit(int number) {
        this.number = number;
    }

    public int number() {
        return number;
    }
}
