package nephele.engine.scene.light;

/** How many rays a bake casts: what the game ships is baked in full, other levels while somebody waits. */
enum BakeEffort {
    FULL,
    RATIONED
}
