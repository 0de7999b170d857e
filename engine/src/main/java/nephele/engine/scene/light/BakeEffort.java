package nephele.engine.scene.light;

/** The ray budget of a bake: full for shipped levels, limited for others, which are baked during loading. */
enum BakeEffort {
    FULL,
    RATIONED
}
