package nephele.engine.scene.thing;

/** Whether a player's figure may ever be seen: what it needs is only built where it may. */
public enum FigurePresence {
    NEVER,
    POSSIBLE
}
