package nephele.editor.pane;

/** What a perspective pane shows of the level. */
public enum ViewMode {
    /** The game's picture: sun, sky, lamps and shadows. */
    LIT,
    /** Materials under an even light, without shadows. */
    UNLIT,
    /** Faces that take portals apart from those that do not. */
    PORTALABLE,
    /** What the player collides with. */
    COLLISION,
    /** Edges only. */
    WIREFRAME
}
