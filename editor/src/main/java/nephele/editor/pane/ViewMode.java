package nephele.editor.pane;

/** The shading of a perspective pane. */
public enum ViewMode {
    /** The game's picture: sun, sky, lamps and shadows. */
    LIT,
    /** Materials under an even light, without shadows. */
    UNLIT,
    /** Faces that take portals apart from those that do not. */
    PORTALABLE,
    /** Shapes that the player collides with. */
    COLLISION,
    /** Edges only. */
    WIREFRAME
}
