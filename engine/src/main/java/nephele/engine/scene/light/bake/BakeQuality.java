package nephele.engine.scene.light.bake;

/** The ray budget of a bake: full for shipped levels, limited for others, which are baked during loading. */
enum BakeQuality {
    FULL,
    RATIONED
}
