package nephele.engine.scene.dynamic;

/** Tells if a player's character may ever be visible; its resources are built only if it may. */
public enum CharacterPresence {
    NEVER,
    POSSIBLE
}
