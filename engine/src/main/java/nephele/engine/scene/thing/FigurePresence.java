package nephele.engine.scene.thing;

/** Tells if a player's character may ever be visible; its resources are built only if it may. */
public enum FigurePresence {
    NEVER,
    POSSIBLE
}
